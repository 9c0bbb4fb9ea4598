"""Draws triangles and strands into a picture on the CPU: depth, materials, simple light; a few milliseconds each."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float32]

SKIN, EYE_LEFT, EYE_RIGHT, TEETH, TONGUE, LASHES, HAIR = range(7)
FAR = np.float32(1e9)


@njit(cache=True)
def normals_of(points, triangles, out):  # type: ignore[no-untyped-def]
    """Vertex normals (V, 3), weighted by area.

    points (V, 3), triangles (t, 3); out (V, 3): is written.
    """
    out[:] = 0.0
    for f in range(triangles.shape[0]):
        a, b, c = triangles[f, 0], triangles[f, 1], triangles[f, 2]
        ux, uy, uz = points[b, 0] - points[a, 0], points[b, 1] - points[a, 1], points[b, 2] - points[a, 2]
        vx, vy, vz = points[c, 0] - points[a, 0], points[c, 1] - points[a, 1], points[c, 2] - points[a, 2]
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        for v in (a, b, c):
            out[v, 0] += nx
            out[v, 1] += ny
            out[v, 2] += nz
    for v in range(out.shape[0]):
        length = np.sqrt(out[v, 0] ** 2 + out[v, 1] ** 2 + out[v, 2] ** 2) + 1e-12
        out[v] /= length


@njit(cache=True)
def draw_triangles(  # type: ignore[no-untyped-def]  # noqa: C901 - one loop over pixels
    screen, triangles, material, lashes, depth, hit, weights
):
    """Finds for each pixel the nearest triangle: depth (H, W), hit (H, W) its row, weights (H, W, 2) in space.

    screen (V, 3): pixels right, pixels down, metres from the camera. lashes: the share of a lash's pixels that is
    drawn.

    triangles (t, 3); material (t,): as `SKIN` and those beside it.
    """
    height, width = depth.shape
    for f in range(triangles.shape[0]):
        a, b, c = triangles[f, 0], triangles[f, 1], triangles[f, 2]
        ax, ay, az = screen[a, 0], screen[a, 1], screen[a, 2]
        bx, by, bz = screen[b, 0], screen[b, 1], screen[b, 2]
        cx, cy, cz = screen[c, 0], screen[c, 1], screen[c, 2]
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        lash = material[f] == LASHES
        if area >= 0.0 and not lash:  # seen from behind: down is +
            continue
        if abs(area) < 1e-9:
            continue
        low_x = max(int(min(ax, bx, cx)), 0)
        high_x = min(int(max(ax, bx, cx)) + 1, width - 1)
        low_y = max(int(min(ay, by, cy)), 0)
        high_y = min(int(max(ay, by, cy)) + 1, height - 1)
        for y in range(low_y, high_y + 1):
            for x in range(low_x, high_x + 1):
                px, py = x + 0.5, y + 0.5
                wb = ((px - ax) * (cy - ay) - (cx - ax) * (py - ay)) / area
                wc = ((bx - ax) * (py - ay) - (px - ax) * (by - ay)) / area
                wa = 1.0 - wb - wc
                if wa < 0.0 or wb < 0.0 or wc < 0.0:
                    continue
                if lash and ((x * 7 + y * 13) % 16) / 16.0 >= lashes:
                    continue
                inverse = wa / az + wb / bz + wc / cz
                z = 1.0 / inverse
                if z < depth[y, x]:
                    depth[y, x] = z
                    hit[y, x] = f
                    weights[y, x, 0] = wb / bz * z
                    weights[y, x, 1] = wc / cz * z


@njit(cache=True)
def draw_strands(screen, shade, colour, thick, depth, hit, picture):  # type: ignore[no-untyped-def]
    """Draws strands (n, k, 3) of screen as lines of a few pixels; shade (n, k) their light, colour (3,).

    thick: pixels; depth, hit (H, W): as of `draw_triangles`; picture (H, W, 3): is painted.
    """
    height, width = depth.shape
    for n in range(screen.shape[0]):
        for k in range(screen.shape[1] - 1):
            ax, ay, az = screen[n, k, 0], screen[n, k, 1], screen[n, k, 2]
            bx, by, bz = screen[n, k + 1, 0], screen[n, k + 1, 1], screen[n, k + 1, 2]
            steps = int(max(abs(bx - ax), abs(by - ay)) / max(thick * 0.5, 1.0)) + 1
            for s in range(steps):
                t = s / steps
                x0, y0, z = ax + t * (bx - ax), ay + t * (by - ay), az + t * (bz - az)
                light = shade[n, k] + t * (shade[n, k + 1] - shade[n, k])
                for y in range(max(int(y0 - thick / 2), 0), min(int(y0 + thick / 2) + 1, height)):
                    for x in range(max(int(x0 - thick / 2), 0), min(int(x0 + thick / 2) + 1, width)):
                        if z < depth[y, x]:
                            depth[y, x] = z
                            hit[y, x] = -2
                            for i in range(3):
                                picture[y, x, i] = colour[i] * light


@njit(cache=True)
def shade_pixels(  # type: ignore[no-untyped-def]  # noqa: C901 - one loop over pixels
    hit, weights, triangles, material, normals, space, uv, openness, local, mask, colours, traits, lamps, picture
):
    """Lights what was hit, linear colours into picture (H, W, 3).

    space (V, 3) metres in the camera's frame; local (V, 3): of eyeballs, on the unit ball, +z the line of sight;
    colours: skin, lip, brow, blush, iris, white, teeth, tongue, lash; traits: brows, blush, iris radius, pupil, gloss;
    lamps: rows of direction (3) and light (3): key, fill; then sky and ground in rows of light.

    hit, weights: of `draw_triangles`; triangles (t, 3), material (t,); normals (V, 3); uv (V, 2); openness (V,): to
    the sky; mask: layers of the skin.
    """
    height, width = hit.shape
    rows = mask.shape[0]
    columns = mask.shape[1]
    for y in range(height):
        for x in range(width):
            f = hit[y, x]
            if f < 0:
                continue
            a, b, c = triangles[f, 0], triangles[f, 1], triangles[f, 2]
            wb, wc = weights[y, x, 0], weights[y, x, 1]
            wa = 1.0 - wb - wc
            nx = wa * normals[a, 0] + wb * normals[b, 0] + wc * normals[c, 0]
            ny = wa * normals[a, 1] + wb * normals[b, 1] + wc * normals[c, 1]
            nz = wa * normals[a, 2] + wb * normals[b, 2] + wc * normals[c, 2]
            length = np.sqrt(nx * nx + ny * ny + nz * nz) + 1e-9
            nx, ny, nz = nx / length, ny / length, nz / length
            sky = wa * openness[a] + wb * openness[b] + wc * openness[c]
            red = 0.0
            green = 0.0
            blue = 0.0
            gloss = 0.15
            left = 1.0
            kind = material[f]
            if kind == SKIN:
                u = wa * uv[a, 0] + wb * uv[b, 0] + wc * uv[c, 0]
                v = wa * uv[a, 1] + wb * uv[b, 1] + wc * uv[c, 1]
                px, py = min(max(int(u * columns), 0), columns - 1), min(max(int(v * rows), 0), rows - 1)
                lips = mask[py, px, 0] / 255.0
                brow = min(1.0, mask[py, px, 1] / 255.0 * 2.0 * traits[0])
                blush = mask[py, px, 2] / 255.0 * traits[1]
                left = mask[py, px, 3] / 255.0
                lips = min(1.0, 1.6 * lips)
                red = colours[0, 0] + blush * (colours[3, 0] - colours[0, 0])
                green = colours[0, 1] + blush * (colours[3, 1] - colours[0, 1])
                blue = colours[0, 2] + blush * (colours[3, 2] - colours[0, 2])
                red += lips * (colours[1, 0] - red)
                green += lips * (colours[1, 1] - green)
                blue += lips * (colours[1, 2] - blue)
                red += brow * (colours[2, 0] - red)
                green += brow * (colours[2, 1] - green)
                blue += brow * (colours[2, 2] - blue)
                gloss = 0.15 + 0.5 * lips * traits[4]
            elif kind in (EYE_LEFT, EYE_RIGHT):
                lx = wa * local[a, 0] + wb * local[b, 0] + wc * local[c, 0]
                ly = wa * local[a, 1] + wb * local[b, 1] + wc * local[c, 1]
                lz = wa * local[a, 2] + wb * local[b, 2] + wc * local[c, 2]
                ln = np.sqrt(lx * lx + ly * ly + lz * lz) + 1e-9
                off = np.sqrt(lx * lx + ly * ly) / ln
                if lz < 0.0:
                    off = 1.0
                edge = traits[2]
                iris = min(1.0, max(0.0, (edge * 1.06 - off) / (edge * 0.12)))
                ring = min(1.0, max(0.0, (off - 0.78 * edge) / (0.2 * edge)))
                hole = min(1.0, max(0.0, (traits[3] * edge - off) / (edge * 0.08) + 0.5))
                for i in range(3):
                    tone = colours[4, i] * (1.0 - 0.7 * ring) * (1.0 - hole) + 0.004 * hole
                    value = colours[5, i] + iris * (tone - colours[5, i])
                    if i == 0:
                        red = value
                    elif i == 1:
                        green = value
                    else:
                        blue = value
                gloss = 2.0
                sky = 0.35 + 0.65 * sky
            else:
                row = 6 if kind == TEETH else (7 if kind == TONGUE else 8)
                red = colours[row, 0]
                green = colours[row, 1]
                blue = colours[row, 2]
            sx = wa * space[a, 0] + wb * space[b, 0] + wc * space[c, 0]
            sy = wa * space[a, 1] + wb * space[b, 1] + wc * space[c, 1]
            sz = wa * space[a, 2] + wb * space[b, 2] + wc * space[c, 2]
            away = np.sqrt(sx * sx + sy * sy + sz * sz) + 1e-9
            vx, vy, vz = -sx / away, -sy / away, -sz / away
            up = 0.5 + 0.5 * ny
            lit0 = 0.0
            lit1 = 0.0
            lit2 = 0.0
            spark0 = 0.0
            spark1 = 0.0
            spark2 = 0.0
            lit0 = (lamps[2, 3] * up + lamps[3, 3] * (1 - up)) * sky
            lit1 = (lamps[2, 4] * up + lamps[3, 4] * (1 - up)) * sky
            lit2 = (lamps[2, 5] * up + lamps[3, 5] * (1 - up)) * sky
            for k in range(2):
                facing = nx * lamps[k, 0] + ny * lamps[k, 1] + nz * lamps[k, 2]
                soft = max(0.0, (facing + 0.25) / 1.25) * (0.25 + 0.75 * sky)
                hx, hy, hz = vx + lamps[k, 0], vy + lamps[k, 1], vz + lamps[k, 2]
                hn = np.sqrt(hx * hx + hy * hy + hz * hz) + 1e-9
                shine = max(0.0, (nx * hx + ny * hy + nz * hz) / hn) ** (60.0 if gloss > 1.0 else 18.0)
                shine *= gloss * (1.0 if facing > 0 else 0.0)
                lit0 += lamps[k, 3] * soft
                lit1 += lamps[k, 4] * soft
                lit2 += lamps[k, 5] * soft
                spark0 += lamps[k, 3] * shine
                spark1 += lamps[k, 4] * shine
                spark2 += lamps[k, 5] * shine
            picture[y, x, 0] = (red * lit0 + 0.2 * spark0) * left
            picture[y, x, 1] = (green * lit1 + 0.2 * spark1) * left
            picture[y, x, 2] = (blue * lit2 + 0.2 * spark2) * left
