#include "viewport/render/OutlinePass.h"

#include <epoxy/gl.h>
#include <glm/common.hpp>

#include <cmath>

namespace rubble {
namespace {

constexpr double kLineWidth = 2.0;   // points, outside of an outline
constexpr double kAreaMargin = 4.0;  // points around the bodies
constexpr double kMaskMargin = 2.0;  // points, more than the lines look at

/// Restricts drawing to the pixels of a box with a margin in points; to the whole image if the box reaches behind the
/// eye.
void setScissor(const RenderView& view, const Box3& box, double marginPoints) {
    Box2 area;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 point((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                         (corner & 4) != 0 ? box.max.z : box.min.z);
        const std::optional<Vec2> pixel = pixelOf(view.camera, point, view.size);
        if (!pixel) return glScissor(0, 0, view.size.width, view.size.height);
        area.include(*pixel);
    }
    const Vec2 size(view.size.width, view.size.height), margin(marginPoints * view.settings.scale);
    const Vec2 low = glm::clamp(area.min - margin, Vec2(0.0), size), high = glm::clamp(area.max + margin, low, size);
    const auto pixels = [](double length) { return static_cast<GLint>(std::ceil(length)); };
    glScissor(static_cast<GLint>(low.x), static_cast<GLint>(size.y - high.y), pixels(high.x - low.x) + 1,
              pixels(high.y - low.y) + 1);
}

}  // namespace

Result<OutlinePass> OutlinePass::create() {
    Result<ShaderProgram> mask = ShaderProgram::create({"bodies.glsl", "outline.glsl", "outline_mask.vert"},
                                                       {"outline.glsl", "outline_mask.frag"});
    if (!mask) return mask.error();
    Result<ShaderProgram> line = ShaderProgram::create({"fullscreen.vert"}, {"outline.glsl", "outline.frag"});
    if (!line) return line.error();
    return OutlinePass(std::move(*mask), std::move(*line));
}

void OutlinePass::draw(const SceneBuffers& scene, const RenderView& view, const OutlineTarget& target) {
    const ImageSize size = view.size;
    m_depths.copy(target.depths, size);  // first: the scissor would cut it
    // A line looks at the mask around it, where it would find what was outlined before if that was not cleared.
    setScissor(view, target.outlined, kAreaMargin + kLineWidth + kMaskMargin);
    glEnable(GL_SCISSOR_TEST);
    if (!m_mask.matches(size, 1)) m_mask = RenderTarget(size, PixelFormat::Number, 1);
    m_mask.bind();
    m_depths.bind();
    constexpr std::uint32_t kNothing[4] = {0, 0, 0, 0};
    glClearBufferuiv(GL_COLOR, 0, kNothing);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);
    m_maskProgram.use();
    if (view.hovered && target.isHovered)
        scene.drawBody(*view.hovered);
    else
        scene.draw(SceneBuffers::Part::Silhouettes);

    setScissor(view, target.outlined, kAreaMargin);
    glBindFramebuffer(GL_FRAMEBUFFER, target.image);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Mask));
    glBindTexture(GL_TEXTURE_2D, m_mask.colourTexture());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_lineProgram.use();
    m_lineProgram.set("lineWidth", static_cast<float>(kLineWidth * view.settings.scale));
    glBindVertexArray(m_emptyArray.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace rubble
