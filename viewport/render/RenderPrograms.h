#pragma once

#include "viewport/render/gl/ShaderProgram.h"

namespace rubble {

/// The variants of a program without and with shadows: a software rasterizer pays for branches that are not taken.
struct LitPrograms {
    ShaderProgram plain, shadowed;
};

/// The variants for batches without a finish, with one, and with an image.
struct SurfacePrograms {
    LitPrograms plain, finished, textured;
};

/// All shader programs.
struct RenderPrograms {
    SurfacePrograms solid, transparent;
    LitPrograms ground, concreteGround, skyFileGround, particles, chips;
    ShaderProgram surfaces, light, lightBlur;  // of the light buffer
    ShaderProgram wires, depth, glassShadow, screenLines, sceneLines, chipShadows, decals, marks, mean;
};

/// Errors: see ShaderProgram::create(), for the first program that fails.
Result<RenderPrograms> compilePrograms();

}  // namespace rubble
