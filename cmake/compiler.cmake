# SPDX-License-Identifier: MIT
#
# csgcast_compiler: what every C and C++ file of ours is compiled with.

add_library(csgcast_compiler INTERFACE)
target_compile_definitions(csgcast_compiler INTERFACE _POSIX_C_SOURCE=200809L)

# No fused multiply-add: the shader's twin, the reference and the packer must get the same bits from
# the same expression whatever the compiler inlines.
target_compile_options(csgcast_compiler INTERFACE
    $<$<COMPILE_LANGUAGE:C>:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion>
    $<$<COMPILE_LANGUAGE:C>:-ffp-contract=off;-fno-math-errno>
    $<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra>)

if(CSGCAST_WERROR)
    target_compile_options(csgcast_compiler INTERFACE -Werror)
endif()
if(CSGCAST_SANITIZE)
    set(sanitize_flags -fsanitize=address,undefined -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
    target_compile_options(csgcast_compiler INTERFACE ${sanitize_flags} -g)
    target_link_options(csgcast_compiler INTERFACE ${sanitize_flags})
endif()

# Our C11 and C++17, not GNU's dialects, for the target given.
function(csgcast_strict target)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:csgcast_compiler>)
    set_target_properties(${target} PROPERTIES
        C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF
        CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
        C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
