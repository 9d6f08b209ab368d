#pragma once

#include "viewport/render/Renderer.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/gl/ShaderProgram.h"

namespace rubble {

/// The bodies whose silhouettes an OutlinePass draws, and where.
struct OutlineTarget {
    Box3 outlined;             // bounds of the bodies, in the world; nothing beyond their pixels is touched
    std::uint32_t depths = 0;  // framebuffer with the depths of the solid surfaces
    std::uint32_t image = 0;   // framebuffer to draw to
    bool isHovered = false;    // of the hovered body, not of the selected ones
};

/// Draws the silhouettes of the selected bodies, or of the hovered one, over an image, fainter where something occludes
/// them. The surfaces of selected bodies stay as they are, that of a hovered one becomes brighter.
class OutlinePass {
public:
    /// Errors: see ShaderProgram::create().
    static Result<OutlinePass> create();

    /// The frame's uniforms are set: with a hovered body, it alone is drawn.
    void draw(const SceneBuffers& scene, const RenderView& view, const OutlineTarget& target);

private:
    OutlinePass(ShaderProgram maskProgram, ShaderProgram lineProgram)
        : m_maskProgram(std::move(maskProgram)), m_lineProgram(std::move(lineProgram)) {}

    ShaderProgram m_maskProgram, m_lineProgram;
    DepthCopy m_depths;
    RenderTarget m_mask;  // numbers of outlines; see outline.glsl
    GlVertexArray m_emptyArray = GlVertexArray::create();
};

}  // namespace rubble
