// Three functions of Emscripten's embind as closures. The originals make functions from strings, which a page may do
// only with 'unsafe-eval'. The build puts these into the glue of MediaPipe in place of those of the same names
// (mediapipe_assets.ts); all that they call is the glue's own.

export function createNamedFunction(name, body) {
  const named = function (...given) {
    return body.apply(this, given);
  };
  Object.defineProperty(named, "name", { value: makeLegalFunctionName(name) });
  return named;
}

export function craftInvokerFunction(humanName, argTypes, classType, cppInvokerFunc, cppTargetFunc) {
  if (argTypes.length < 2) {
    throwBindingError("argTypes array size mismatch! Must at least get return value and 'this' types!");
  }
  const [returned, self, ...given] = argTypes;
  const ofClass = self !== null && classType !== null;
  const stacked = argTypes.slice(1).some((type) => type !== null && type.destructorFunction === undefined);
  return createNamedFunction(humanName, function (...args) {
    if (args.length !== given.length) {
      throwBindingError(`function ${humanName} called with ${args.length} arguments, expected ${given.length} args!`);
    }
    const destructors = stacked ? [] : null;
    const types = ofClass ? [self, ...given] : given;
    const values = ofClass ? [this, ...args] : args;
    const wired = types.map((type, place) => type.toWireType(destructors, values[place]));
    const result = cppInvokerFunc(cppTargetFunc, ...wired);
    if (stacked) {
      runDestructors(destructors);
    } else {
      types.forEach((type, place) => {
        if (type.destructorFunction !== null) type.destructorFunction(wired[place]);
      });
    }
    return returned.name === "void" ? undefined : returned.fromWireType(result);
  });
}

export function __emval_get_method_caller(argCount, argTypes) {
  const [returned, ...given] = __emval_lookupTypes(argCount, argTypes);
  const signature = `${returned.name}_$${given.map((type) => type.name).join("_")}$`;
  const caller = createNamedFunction(`methodCaller_${signature}`, (handle, name, destructors, packed) => {
    let offset = 0;
    const values = given.map((type) => {
      const value = type.readValueFromPointer(packed + offset);
      offset += type.argPackAdvance;
      return value;
    });
    const result = handle[name](...values);
    given.forEach((type, place) => {
      if (type.deleteObject) type.deleteObject(values[place]);
    });
    return returned.isVoid ? undefined : returned.toWireType(destructors, result);
  });
  return __emval_addMethodCaller(caller);
}
