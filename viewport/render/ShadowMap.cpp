#include "viewport/render/ShadowMap.h"

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace rubble {
namespace {

void bindTo(TextureUnit unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

void setFilter(GLint filter) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// A depth texture that shaders compare with, bound to a unit.
GlTexture comparedDepths(TextureUnit unit, int width) {
    GlTexture made = GlTexture::create();
    bindTo(unit, made);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, width, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    setFilter(GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    return made;
}

GlFramebuffer depthTarget(const GlTexture& depths) {
    GlFramebuffer made = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, made.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths.id(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return made;
}

}  // namespace

glm::dmat4 clipFromWorldOfLight(Vec3 direction, const LightRegion& region) {
    const double radius = region.radius;
    const Vec3 up = std::abs(direction.y) > 0.9 ? Vec3(0.0, 0.0, -1.0) : Vec3(0.0, 1.0, 0.0);
    return glm::ortho(-radius, radius, -radius, radius, 0.0, 2.0 * radius) *
           glm::lookAt(region.centre + radius * direction, region.centre, up);
}

glm::dmat4 textureFromWorldOfLight(Vec3 direction, const LightRegion& region) {
    return glm::scale(glm::translate(glm::dmat4(1.0), Vec3(0.5)), Vec3(0.5)) * clipFromWorldOfLight(direction, region);
}

/// Faces towards the light alone: solids are closed. Bodies before and behind the region lie on its near and far plane.
ShadowState::ShadowState() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 4.0f);  // more than the depth slope within a filter's texels, against shadow acne
}
ShadowState::~ShadowState() {
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CULL_FACE);
}

ShadowMap::ShadowMap(int width)
    : m_width(width),
      m_depths(comparedDepths(TextureUnit::KeyShadow, width)),
      m_framebuffer(depthTarget(m_depths)),
      m_uncompared(GlSampler::create()) {
    glSamplerParameteri(m_uncompared.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(m_uncompared.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(m_uncompared.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(m_uncompared.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(m_uncompared.id(), GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

void ShadowMap::draw(const SceneBuffers& scene, const RenderPrograms& programs, Vec3 direction,
                     const LightRegion& region, bool hasTransparent) {
    const glm::dmat4 origin = glm::translate(glm::dmat4(1.0), scene.scene()->origin);
    const glm::mat4 clip(clipFromWorldOfLight(direction, region) * origin);
    m_textureFromScene = glm::mat4(textureFromWorldOfLight(direction, region) * origin);
    const ShadowState state;
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glViewport(0, 0, m_width, m_width);
    glClear(GL_DEPTH_BUFFER_BIT);
    programs.depth.use();
    programs.depth.set("clipFromSceneOfLight", clip);
    programs.depth.set("surfaces", kOpaqueSurfaces);
    programs.depth.set("pattern", 0u);
    scene.draw(SceneBuffers::Part::Silhouettes);
    if (hasTransparent) drawGlass(scene, programs, clip);
}

/// First what they leave of the light, in any order, then the nearest depths. In red is the product over surfaces that
/// were outside, in alpha the least over fracture surfaces: a ray meets many of these between fragments that touch.
void ShadowMap::drawGlass(const SceneBuffers& scene, const RenderPrograms& programs, const glm::mat4& clip) {
    if (m_glass.id() == 0) {
        m_glassDepths = comparedDepths(TextureUnit::KeyGlassShadow, m_width);
        m_glassFramebuffer = depthTarget(m_glassDepths);
        m_glass = GlTexture::create();
        bindTo(TextureUnit::KeyGlass, m_glass);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, m_width, m_width, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        setFilter(GL_LINEAR);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_glass.id(), 0);
        glDrawBuffer(GL_COLOR_ATTACHMENT0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_glassFramebuffer.id());
    constexpr float kAll[] = {1.0f, 1.0f, 1.0f, 1.0f};
    glClearBufferfv(GL_COLOR, 0, kAll);
    glClear(GL_DEPTH_BUFFER_BIT);
    programs.glassShadow.use();
    programs.glassShadow.set("clipFromSceneOfLight", clip);
    programs.glassShadow.set("surfaces", kTransparentSurfaces);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendEquationSeparate(GL_FUNC_ADD, GL_MIN);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    scene.draw(SceneBuffers::Part::Silhouettes);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    scene.draw(SceneBuffers::Part::Silhouettes);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void ShadowMap::bind() const {
    bindTo(TextureUnit::KeyShadow, m_depths);
    bindTo(TextureUnit::KeyDepths, m_depths);
    glBindSampler(static_cast<GLuint>(TextureUnit::KeyDepths), m_uncompared.id());
    bindTo(TextureUnit::KeyGlass, m_glass);
    bindTo(TextureUnit::KeyGlassShadow, m_glassDepths.id() != 0 ? m_glassDepths : m_depths);
}

}  // namespace rubble
