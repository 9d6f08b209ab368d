#pragma once

#include "viewport/render/ShaderProgram.h"

namespace rubble {

enum class Light { Plain, Shadowed, Sampled };

/// What is drawn with light, in the three ways of shadow.glsl.
struct LitPrograms {
    ShaderProgram plain, shadowed, sampled;
};

/// All programs of resources/shaders.
struct RenderPrograms {
    LitPrograms solid, heated, shade;
    ShaderProgram lines, depth, pick, sky, grid, strokes, spans, dust, mean;
};

/// Errors: those of ShaderProgram::made(), of the first that fails.
Result<RenderPrograms> madePrograms();

}  // namespace rubble
