#pragma once

#include "viewport/render/ShaderProgram.h"

namespace rubble {

enum class Light { Plain, Shadowed, Sampled };

/// The three lighting variants of a program: see shadow.glsl.
struct LitPrograms {
    ShaderProgram plain, shadowed, sampled;
};

/// All shader programs.
struct RenderPrograms {
    LitPrograms solid, transparent, groundShadow;
    ShaderProgram wires, depth, ditheredDepth, pick, sky, grid, screenLines, sceneLines, dust, mean;
};

/// Errors: see ShaderProgram::create(), for the first program that fails.
Result<RenderPrograms> compilePrograms();

}  // namespace rubble
