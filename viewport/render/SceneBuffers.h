#pragma once

#include "viewport/render/RenderCounts.h"
#include "viewport/render/gl/TexelBuffer.h"
#include "viewport/scene/RenderScene.h"

#include <memory>
#include <vector>

namespace rubble {

/// The uniform `surfaces` of programs with bodies.glsl.
inline constexpr std::uint32_t kAllSurfaces = 0, kOpaqueSurfaces = 1, kTransparentSurfaces = 2;

/// A scene in GPU memory. Geometry stays there as long as successive scenes share it; per-body data is rewritten when
/// it changes.
class SceneBuffers {
public:
    SceneBuffers();

    /// Errors: throws std::bad_alloc, and keeps the scene that it has, if the scene's geometry is new and there is not
    /// the memory to draw it in software.
    void upload(std::shared_ptr<const RenderScene> scene);
    const std::shared_ptr<const RenderScene>& scene() const { return m_scene; }

    enum class Part { Bodies, Hulls };
    /// Plain: those without an image, or with one that cannot be decoded.
    enum class Batches { All, Plain, Textured };
    /// Draws all triangles with the current program: one call per batch, or two where some of its instances are whole
    /// and others are not. Of whole instances, only the whole is drawn.
    void draw(Part part, Batches batches = Batches::All) const;
    bool hasTextures() const { return !m_textures.empty(); }
    const RenderCounts& counts() const { return m_counts; }

private:
    struct Geometry {
        std::shared_ptr<const SceneGeometry> source;
        GlBuffer vertices;
        GlBuffer indices;
    };
    struct Batch {
        GlBuffer firstBodies;  // of the instances in parts, then of those that are whole
        GlVertexArray bodies;
        GlVertexArray wholeBodies;          // the same, beginning with the first whole instance
        std::vector<std::uint8_t> isWhole;  // of the instances, in the order of the scene
        std::size_t inParts = 0;            // how many are not whole
        GlVertexArray hulls;
        std::uint32_t texture = 0;  // 0: none
    };
    struct Texture {
        std::shared_ptr<const EncodedImage> source;
        GlTexture texels;  // none: it cannot be decoded
    };
    void uploadBatches();
    void sortInstances(const SceneBatch& source, Batch& batch);
    const Geometry& uploaded(const std::shared_ptr<const SceneGeometry>& source);
    std::uint32_t uploaded(const std::shared_ptr<const EncodedImage>& source);
    Batch batchOf(const SceneBatch& batch);

    std::shared_ptr<const RenderScene> m_scene;
    std::vector<Geometry> m_geometries;
    std::vector<Texture> m_textures;
    std::vector<Batch> m_batches;
    TexelBuffer m_poses, m_previousPoses, m_explodeOffsets, m_appearances;
    mutable RenderCounts m_counts;
};

}  // namespace rubble
