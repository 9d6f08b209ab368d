#pragma once

#include "viewport/render/RenderTarget.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/ShaderProgram.h"

namespace rubble {

/// Draws the silhouettes of the selected bodies and of the hovered one over an image, fainter where something occludes
/// them. Their surfaces stay as they are.
class OutlinePass {
public:
    /// Errors: see ShaderProgram::create().
    static Result<OutlinePass> create();

    /// Draws to the bound framebuffer, whose depths are those of the solid surfaces. `outlined`: bounds of the bodies,
    /// in the world; nothing beyond their pixels is touched.
    void draw(const SceneBuffers& scene, const RenderView& view, const Box3& outlined);

private:
    OutlinePass(ShaderProgram maskProgram, ShaderProgram lineProgram)
        : m_maskProgram(std::move(maskProgram)), m_lineProgram(std::move(lineProgram)) {}

    ShaderProgram m_maskProgram, m_lineProgram;
    DepthCopy m_depths;
    RenderTarget m_mask;  // numbers of outlines; see outline.glsl
    GlVertexArray m_emptyArray = GlVertexArray::create();
};

}  // namespace rubble
