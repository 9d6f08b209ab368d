#include "viewport/render/ShadowMap.h"

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace rubble {
namespace {

/// The light's view projection: an orthographic cube around the bounding sphere of a box.
glm::dmat4 clipFromScene(Vec3 direction, const Box3& bounds, Vec3 origin) {
    const double radius = 0.5 * bounds.diagonal() * 1.01 + 1e-6;
    const Vec3 centre = bounds.centre() - origin;
    const Vec3 up = std::abs(direction.y) > 0.9 ? Vec3(0.0, 0.0, -1.0) : Vec3(0.0, 1.0, 0.0);
    return glm::ortho(-radius, radius, -radius, radius, 0.0, 2.0 * radius) *
           glm::lookAt(centre + radius * direction, centre, up);
}

}  // namespace

ShadowMap::ShadowMap(int width)
    : m_width(width), m_depths(GlTexture::create()), m_framebuffer(GlFramebuffer::create()) {
    glBindTexture(GL_TEXTURE_2D, m_depths.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, width, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depths.id(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

void ShadowMap::draw(const SceneBuffers& scene, const RenderPrograms& programs, Vec3 direction,
                     const SceneSummary& summary, int pattern) {
    const glm::dmat4 clip = clipFromScene(direction, summary.bounds, scene.scene()->origin);
    const glm::dmat4 texture = glm::scale(glm::translate(glm::dmat4(1.0), Vec3(0.5)), Vec3(0.5));
    m_textureFromScene = glm::mat4(texture * clip);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glViewport(0, 0, m_width, m_width);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2.5f,
                    4.0f);  // more than the depth slope within the filter's texels, against shadow acne
    const auto drawSurfaces = [&](const ShaderProgram& program, std::uint32_t surfaces) {
        program.use();
        program.set("clipFromSceneOfLight", glm::mat4(clip));
        program.set("surfaces", surfaces);
        program.set("patternIndex", static_cast<float>(pattern));
        scene.draw(SceneBuffers::Part::Bodies);
    };
    drawSurfaces(programs.depth, kOpaqueSurfaces);
    if (summary.hasTransparent) drawSurfaces(programs.ditheredDepth, kTransparentSurfaces);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShadowMap::bind(TextureUnit unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, m_depths.id());
}

}  // namespace rubble
