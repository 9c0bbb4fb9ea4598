document.body.textContent = "The console is being built.";
