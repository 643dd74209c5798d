# SPDX-License-Identifier: MIT
#
#   awk -f tachyon.awk -v camera=ex,ey,ez,cx,cy,cz -v size=W,H LIST > scene.dat
#
# crowd.awk's lists for Tachyon. Its space is left-handed: x is mirrored in scene and camera.

BEGIN {
    split(camera, c, ","); split(size, s, ",")
    printf "BEGIN_SCENE\nRESOLUTION %d %d\n", s[1], s[2]
    printf "CAMERA PROJECTION PERSPECTIVE ZOOM %.9g ASPECTRATIO 1.0 ANTIALIASING 0 RAYDEPTH 1\n",
        0.5 / 0.198912367
    printf "CENTER %.9g %.9g %.9g\n", -c[1], c[2], c[3]
    printf "VIEWDIR %.9g %.9g %.9g\n", c[1] - c[4], c[5] - c[2], c[6] - c[3]
    print "UPDIR 0 0 1\nEND_CAMERA\nBACKGROUND 1 1 0.898"
    printf "DIRECTIONAL_LIGHT DIRECTION %.9g %.9g %.9g COLOR 1 1 1\n", c[1] - c[4], c[5] - c[2], c[6] - c[3]
    print "TEXDEF face AMBIENT 0.2 DIFFUSE 0.8 SPECULAR 0 OPACITY 1 COLOR 0.976 0.843 0.173 TEXFUNC 0"
}
$1 == "sphere" { print "SPHERE CENTER", -$2, $3, $4, "RAD", $5, "face" }
$1 == "cylinder" { print "FCYLINDER BASE", -$2, $3, $4, "APEX", -$5, $6, $7, "RAD", $8, "face" }
END { print "END_SCENE" }
