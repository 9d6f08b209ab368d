#pragma once

#include "viewport/render/InstanceFilter.h"
#include "viewport/render/RenderCounts.h"
#include "viewport/render/SceneTextures.h"
#include "viewport/render/gl/TexelBuffer.h"
#include "viewport/scene/RenderScene.h"

#include <functional>
#include <memory>
#include <unordered_map>
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

    /// Sets the view of Part::Bodies.
    void setView(const InstanceView& view);

    /// See Renderer::setInterruption(). From an interruption to the next restart(), nothing is drawn.
    void setInterruption(std::function<bool()> isInterrupted) { m_interruption = std::move(isInterrupted); }
    void restart() { m_isInterrupted = false; }
    bool isInterrupted() const { return m_isInterrupted; }

    /// Bodies: as the view that was set shows them. Silhouettes: an instance whose solids look alike and are where they
    /// were cut is drawn as a whole, which covers the same pixels from all sides.
    enum class Part { Bodies, Silhouettes, Hulls };
    /// Textured: those with an image that is decoded. Finished: others that have a finish.
    enum class Batches { All, Plain, Finished, Textured };
    /// Draws all triangles with the current program: one call per batch, or two where some of its instances are whole
    /// and others are not, and one more for every few hundred thousand triangles.
    void draw(Part part, Batches batches = Batches::All) const;
    /// How many triangles draw(Part::Bodies) draws.
    std::size_t bodyTriangles() const;
    /// Draws one body.
    void drawBody(std::uint32_t body) const;
    bool hasFinishes() const { return m_hasFinishes; }
    bool hasTextures() const { return !m_textures.isEmpty(); }
    SceneTextures& textures() { return m_textures; }
    const RenderCounts& counts() const { return m_counts; }

private:
    struct Geometry {
        std::shared_ptr<const SceneGeometry> source;
        GlBuffer vertices;
        GlBuffer indices;
    };
    /// How an instance can be drawn.
    enum class Whole : std::uint8_t {
        Never,   // its solids differ
        Always,  // its whole is a solid of its own, and the only one shown
        Equal,   // its solids look alike, so that either will do
    };
    struct Batch {
        GlBuffer firstBodies;  // of the instances, in the order of `order`
        GlVertexArray bodies;
        GlVertexArray hulls;
        GlBuffer finishes;          // none without
        double meanPartSize = 0.0;  // m
        bool hasMortar = false;     // between its fragments
        std::vector<Whole> wholes;  // of the instances, in the order of the scene
        // The first bodies as uploaded: of instances in parts, then
        std::vector<std::uint32_t> order;
        std::size_t equalBegin = 0;   // of those whose silhouettes are whole,
        std::size_t wholeBegin = 0;   // of those that are drawn whole,
        std::size_t unseenBegin = 0;  // and of others of these two kinds that the view does not show
    };
    void uploadBatches();
    void findWholes(const SceneBatch& source, Batch& batch) const;
    void sortInstances();
    void sortInstances(const SceneBatch& source, const InstanceFilter& filter, Batch& batch);
    const Geometry& uploaded(const std::shared_ptr<const SceneGeometry>& source);
    Batch batchOf(const SceneBatch& batch);
    void bindTexels() const;
    Batches kindOf(const SceneBatch& source) const;
    void drawInstances(const Batch& batch, const GlVertexArray& array, TriangleRange indices, std::size_t begin,
                       std::size_t end) const;

    std::shared_ptr<const RenderScene> m_scene;
    InstanceView m_view;
    std::shared_ptr<const std::vector<glm::vec4>> m_restSource;  // of m_restOffsets
    std::unordered_map<const SceneGeometry*, Geometry> m_geometries;
    SceneTextures m_textures;
    std::vector<Batch> m_batches;
    TexelBuffer m_poses, m_previousPoses, m_explodeOffsets, m_appearances, m_restOffsets;
    bool m_hasFinishes = false;
    std::function<bool()> m_interruption;
    mutable bool m_isInterrupted = false;
    mutable RenderCounts m_counts;
};

}  // namespace rubble
