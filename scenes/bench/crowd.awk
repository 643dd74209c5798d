# SPDX-License-Identifier: MIT
#
#   awk -f crowd.awk -v kind=sphereflake -v level=5 > sphereflake.csg
#
# Crowds of solids, too many for OpenSCAD's language. Kinds and what they take:
#
#   sphereflake  level   1, 10, 91, 820, 7381, 66430, 597871 spheres for level 0 to 6
#   spheres      n       on a jittered grid
#   molecule     n       likewise, with about two cylinders a sphere between neighbours
#   ellipsoids   n       turned and squeezed spheres
#
# -v format=list gives one solid a line instead, for other renderers: "sphere x y z r" and
# "cylinder x y z x y z r". -v seed=N takes other random numbers.

BEGIN {
    seed = seed == "" ? 1 : seed
    state = seed * 7919 + 17
    n = n == "" ? 1000 : n
    if (kind == "sphereflake")
        flake(0, 0, 0, 1, 0, 0, 1, level + 0)
    else if (kind == "spheres" || kind == "molecule")
        grid(kind == "molecule")
    else if (kind == "ellipsoids")
        ellipsoids()
    else {
        print "crowd.awk: kind is sphereflake, spheres, molecule or ellipsoids" > "/dev/stderr"
        exit 2
    }
}

# The same in every awk (Park and Miller 1988).
function random() {
    state = (state * 16807) % 2147483647
    return state / 2147483647
}

function sphere(x, y, z, r) {
    if (format == "list")
        printf "sphere %.9g %.9g %.9g %.9g\n", x, y, z, r
    else
        printf "multmatrix([[1,0,0,%.9g],[0,1,0,%.9g],[0,0,1,%.9g],[0,0,0,1]]) sphere(r = %.9g);\n",
            x, y, z, r
}

# Axes u, v of the plane across the unit vector w, into the globals ux .. vz.
function across(wx, wy, wz,    l) {
    if (wx * wx < 0.8) { ux = 0; uy = -wz; uz = wy } else { ux = wz; uy = 0; uz = -wx }
    l = sqrt(ux * ux + uy * uy + uz * uz)
    ux /= l; uy /= l; uz /= l
    vx = wy * uz - wz * uy; vy = wz * ux - wx * uz; vz = wx * uy - wy * ux
}

function cylinder(x0, y0, z0, x1, y1, z1, r,    wx, wy, wz, h) {
    if (format == "list") {
        printf "cylinder %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", x0, y0, z0, x1, y1, z1, r
        return
    }
    wx = x1 - x0; wy = y1 - y0; wz = z1 - z0
    h = sqrt(wx * wx + wy * wy + wz * wz)
    wx /= h; wy /= h; wz /= h
    across(wx, wy, wz)
    printf "multmatrix([[%.9g,%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g,%.9g],[0,0,0,1]]) ",
        ux, vx, wx, x0, uy, vy, wy, y0, uz, vz, wz, z0
    printf "cylinder(h = %.9g, r = %.9g);\n", h, r
}

# Haines' sphereflake: nine spheres of a third of the radius around each, six about its equator and
# three nearer to its pole (wx wy wz), all of them pointing outwards.
function flake(x, y, z, wx, wy, wz, r, level,    i, a, up, out, dx, dy, dz, ax, ay, az, bx, by, bz) {
    sphere(x, y, z, r)
    if (level == 0)
        return
    across(wx, wy, wz)
    ax = ux; ay = uy; az = uz; bx = vx; by = vy; bz = vz
    for (i = 0; i < 9; i++) {
        a = (i < 6 ? i / 6 : (i - 6) / 3 + 1 / 12) * 6.283185307179586
        up = i < 6 ? 0 : 0.816496580927726
        out = sqrt(1 - up * up)
        dx = out * (cos(a) * ax + sin(a) * bx) + up * wx
        dy = out * (cos(a) * ay + sin(a) * by) + up * wy
        dz = out * (cos(a) * az + sin(a) * bz) + up * wz
        flake(x + 4 / 3 * r * dx, y + 4 / 3 * r * dy, z + 4 / 3 * r * dz, dx, dy, dz, r / 3,
              level - 1)
    }
}

# Points of a jittered grid, unit pitch, in a cube about the origin.
function grid(bonded,    side, i, x, y, z, px, py, pz) {
    side = int(exp(log(n) / 3) + 0.999999)
    for (i = 0; i < n; i++) {
        x = i % side; y = int(i / side) % side; z = int(i / side / side)
        px[i] = x - side / 2 + 0.6 * random()
        py[i] = y - side / 2 + 0.6 * random()
        pz[i] = z - side / 2 + 0.6 * random()
        sphere(px[i], py[i], pz[i], (bonded ? 0.2 : 0.3) + 0.1 * random())
    }
    for (i = 0; bonded && i < n; i++) {
        if (i % side < side - 1 && i + 1 < n)
            cylinder(px[i], py[i], pz[i], px[i + 1], py[i + 1], pz[i + 1], 0.08)
        if (int(i / side) % side < side - 1 && i + side < n)
            cylinder(px[i], py[i], pz[i], px[i + side], py[i + side], pz[i + side], 0.08)
    }
}

function ellipsoids(    side, i, a, b, c, s) {
    side = exp(log(n) / 3)
    for (i = 0; i < n; i++) {
        a = 6.283185307179586 * random(); c = 2 * random() - 1; s = sqrt(1 - c * c)
        across(s * cos(a), s * sin(a), c)
        wx = s * cos(a); wy = s * sin(a); wz = c
        a = 0.2 + 0.6 * random(); b = 0.2 + 0.6 * random(); c = 0.2 + 0.6 * random()
        printf "multmatrix([[%.9g,%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g,%.9g],[0,0,0,1]]) sphere(r = 1);\n",
            a * ux, b * vx, c * wx, side * (random() - 0.5), a * uy, b * vy, c * wy,
            side * (random() - 0.5), a * uz, b * vz, c * wz, side * (random() - 0.5)
    }
}
