# SPDX-License-Identifier: MIT
#
#   awk -F, -f bars.awk results.csv
#
# What is asked of csgcast, as ratios, and what was measured: by the clock and by the processor time
# of all cores, which decides where it is known (Tachyon does not tell that of tracing alone), as it
# depends least on what else the machine does.

NR > 1 { value[$1, $2, $3] = $4; iou[$1, $2] = $8 }

function ratio(a, b, what) {
    return ((a, what) in value) && value[b, what] > 0 ? value[a, what] / value[b, what] : ""
}

function show(x) {
    return x == "" ? "" : sprintf(x < 10 ? "%.2f" : "%.0f", x)
}

# a and b are "case,renderer"; what is frame or process.
function bar(text, a, b, least, limit, what,    clock, work, other, met) {
    gsub(",", SUBSEP, a); gsub(",", SUBSEP, b)
    clock = ratio(a, b, what == "process" ? "process_ms" : "frame_ms")
    work = ratio(a, b, what == "process" ? "process_work_ms" : "work_ms")
    if (what == "mixed") { # a whole process against a frame
        if (((a, "process_ms") in value) && value[b, "frame_ms"] > 0) {
            clock = value[a, "process_ms"] / value[b, "frame_ms"]
            work = value[a, "process_work_ms"] / value[b, "work_ms"]
        }
    }
    other = work == "" ? clock : work
    met = other == "" ? "not measured" : (least ? other >= limit : other <= limit) ? "yes" : "no"
    printf "| %s | %s %s | %s | %s | %s |\n", text, least ? "at least" : "at most", limit,
        show(clock), show(work), met
}

function at_least(text, a, b, limit, what) { bar(text, a, b, 1, limit, what) }
function at_most(text, a, b, limit, what) { bar(text, a, b, 0, limit, what) }

END {
    print "| frame or process | asked | by the clock | by processor time | met |"
    print "| --- | --- | --- | --- | --- |"
    at_least("five: `--variant=algorithm4` over the default", "five,algorithm4", "five,csgcast", 6)
    at_most("five: over the shader written by hand", "five,csgcast", "five,hand-written", 1.5)
    at_least("five: OpenCSG, 64 facets, over csgcast", "five,opencsg", "five,csgcast", 5)
    at_least("five: finished mesh of 256 facets over csgcast", "five,mesh-256", "five,csgcast", 1)
    at_most("plate: 1,024 holes over 100", "plate32,csgcast", "plate10,csgcast", 2)
    at_least("plate, 1,024 holes: OpenCSG over csgcast", "plate32,opencsg", "plate32,csgcast", 10)
    at_least("plate, 1,024 holes: libfive over csgcast", "plate32,libfive", "plate32,csgcast", 10)
    for (n = 4; n <= 5; n++) {
        at_least("Menger " n ": OpenSCAD's preview over csgcast, whole process",
            "menger" n ",openscad-preview", "menger" n ",csgcast", 5, "process")
        at_least("Menger " n ": OpenSCAD's preview over a frame", "menger" n ",openscad-preview",
            "menger" n ",csgcast", 30, "mixed")
    }
    at_most("blow: k = 64 over k = 4 (linear: 16)", "blow64,csgcast", "blow4,csgcast", 16)
    at_least("nested, 256: libfive over csgcast", "nested256,libfive", "nested256,csgcast", 3)
    at_least("nested, 256: POV-Ray over csgcast", "nested256,povray", "nested256,csgcast", 10)
    at_most("nested: 4,096 over 256", "nested4096,csgcast", "nested256,csgcast", 4)
    at_least("sphereflake 1: meshes of 16 x 8 over csgcast", "flake0,mesh-16x8", "flake0,csgcast", 1)
    at_least("sphereflake 91: likewise", "flake2,mesh-16x8", "flake2,csgcast", 2)
    at_least("sphereflake 7,381: likewise", "flake4,mesh-16x8", "flake4,csgcast", 2)
    at_least("sphereflake 66,430: likewise", "flake5,mesh-16x8", "flake5,csgcast", 10)
    n = split("flake5 spheres molecule", crowd, " ")
    name["flake5"] = "sphereflake 66,430"
    name["spheres"] = "99,130 spheres"
    name["molecule"] = "99,130 spheres, 194,035 cylinders"
    for (i = 1; i <= n; i++) {
        at_most(name[crowd[i]] ": over Embree", crowd[i] ",csgcast", crowd[i] ",embree", 1.5)
        at_least(name[crowd[i]] ": Tachyon over csgcast", crowd[i] ",tachyon", crowd[i] ",csgcast", 1)
        at_least(name[crowd[i]] ": POV-Ray over csgcast", crowd[i] ",povray", crowd[i] ",csgcast", 1)
        if (i > 1)
            at_least(name[crowd[i]] ": PyMOL's ray tracer over csgcast", crowd[i] ",pymol-ray",
                crowd[i] ",csgcast", 1)
    }
    n = split("five plate10", first, " ")
    for (i = 1; i <= n; i++) {
        text = first[i] == "five" ? "five" : "101 solids"
        at_least("first image of " text ", whole process: OpenSCAD's preview over csgcast",
            "first-" first[i] ",openscad-preview", "first-" first[i] ",csgcast", 1, "process")
        at_least("first image of " text ": POV-Ray over csgcast", "first-" first[i] ",povray",
            "first-" first[i] ",csgcast", 1, "process")
    }
    n = split("five plate10 plate32 nested256 rack", edited, " ")
    for (i = 1; i <= n; i++) {
        text = edited[i] ": over an orbit's frame"
        at_most("one matrix edited, " text, "edit-" edited[i] ",edit", "edit-" edited[i] ",orbit", 1.2)
        at_most("parameters edited, " text, "edit-" edited[i] ",edit-parameters",
            "edit-" edited[i] ",orbit", 1.2)
        at_most("a colour edited, " text, "edit-" edited[i] ",edit-color",
            "edit-" edited[i] ",orbit", 1.2)
    }
}
