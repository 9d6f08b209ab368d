#include "viewport/render/SkyMaps.h"

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace rubble {
namespace {

/// The uniform block Sky of sky.glsl.
struct SkyBlock {
    glm::mat4 skyFromScene[SkyMaps::kMost];
    glm::vec4 skyDirections[SkyMaps::kMost];
    glm::vec4 skyCount;
};

constexpr double kSkyLift = 0.75;  // texels, by which points are lifted off their surface against shadow acne
constexpr double kKeyLift = 3e-4;  // of the region's radius, the same for the key light

}  // namespace

SkyMaps::SkyMaps(int width) : m_width(width), m_depths(GlTexture::create()), m_uniforms(GlBuffer::create()) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::SkyShadows));
    glBindTexture(GL_TEXTURE_2D_ARRAY, m_depths.id());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void SkyMaps::draw(const SceneBuffers& scene, const RenderPrograms& programs, std::span<const Vec3> directions,
                   const LightRegion& region, int most) {
    const bool isSame = std::ranges::equal(directions, m_maps, {}, {}, &Map::direction);
    if (!isSame) {
        RUBBLE_ASSERT(directions.size() <= kMost);
        const bool isLarger = directions.size() > m_framebuffers.size();
        m_maps.clear();
        for (const Vec3& direction : directions) m_maps.push_back({direction});
        m_rendered = m_next = 0;
        if (isLarger) allocate();
    }
    if (!isSame || region != m_region) invalidate();
    m_region = region;
    if (isCurrent()) return;
    const ShadowState state;
    for (; m_outdated > 0 && most > 0; --m_outdated, --most) {
        render(m_next, scene, programs);
        m_rendered = std::max(m_rendered, ++m_next);
        m_next %= static_cast<int>(m_maps.size());
    }
}

void SkyMaps::allocate() {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::SkyShadows));
    glBindTexture(GL_TEXTURE_2D_ARRAY, m_depths.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, m_width, m_width, static_cast<GLsizei>(m_maps.size()),
                 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    m_framebuffers.clear();
    for (GLint layer = 0; layer < static_cast<GLint>(m_maps.size()); ++layer) {
        m_framebuffers.push_back(GlFramebuffer::create());
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers.back().id());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, m_depths.id(), 0, layer);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
}

/// Of transparent bodies each map holds a part: in the mean over all maps, each is there as often as it is opaque.
void SkyMaps::render(int layer, const SceneBuffers& scene, const RenderPrograms& programs) {
    Map& map = m_maps[static_cast<std::size_t>(layer)];
    map.textureFromWorld = textureFromWorldOfLight(map.direction, m_region);
    const glm::dmat4 origin = glm::translate(glm::dmat4(1.0), scene.scene()->origin);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[static_cast<std::size_t>(layer)].id());
    glViewport(0, 0, m_width, m_width);
    glClear(GL_DEPTH_BUFFER_BIT);
    programs.depth.use();
    programs.depth.set("clipFromSceneOfLight", glm::mat4(clipFromWorldOfLight(map.direction, m_region) * origin));
    programs.depth.set("surfaces", kAllSurfaces);
    programs.depth.set("pattern", static_cast<std::uint32_t>(layer + 1));
    scene.draw(SceneBuffers::Part::Silhouettes);
}

void SkyMaps::bind(Vec3 origin) const {
    SkyBlock block{};
    const glm::dmat4 offset = glm::translate(glm::dmat4(1.0), origin);
    for (std::size_t k = 0; k < m_maps.size(); ++k) {
        block.skyFromScene[k] = glm::mat4(m_maps[k].textureFromWorld * offset);
        block.skyDirections[k] = glm::vec4(glm::vec3(m_maps[k].direction), 0.0f);
    }
    block.skyCount = glm::vec4(m_rendered, kSkyLift * 2.0 * m_region.radius / m_width, kKeyLift * m_region.radius, 0.0);
    glBindBuffer(GL_UNIFORM_BUFFER, m_uniforms.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, m_uniforms.id());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::SkyShadows));
    glBindTexture(GL_TEXTURE_2D_ARRAY, m_depths.id());
}

}  // namespace rubble
