#include "viewport/render/SceneBuffers.h"

#include "core/asset/finish/FinishParameters.h"
#include "viewport/render/InstanceFilter.h"
#include "viewport/render/SceneMemory.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <unordered_set>
#include <utility>

namespace rubble {
namespace {

static_assert(sizeof(RenderPose) == 32 && sizeof(BodyAppearance) == 16, "texels of buffer textures");

template <class T>
GlBuffer bufferOf(std::uint32_t target, const std::vector<T>& values) {
    GlBuffer buffer = GlBuffer::create();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    return buffer;
}

void bindTexture(std::uint32_t texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::BaseColour));
    glBindTexture(GL_TEXTURE_2D, texture);
}

constexpr GLuint kFinishesBlock = 2;  // see ShaderProgram

/// Of the box of an asset, m.
Vec3 wholeSize(const SceneGeometry& geometry) {
    if (geometry.whole != SceneGeometry::Whole::None) return geometry.wholeBox.max - geometry.wholeBox.min;
    return geometry.boxes.empty() ? Vec3(1.0) : geometry.boxes.front().max - geometry.boxes.front().min;
}

/// The uniform block of finish.glsl: of the outside, of the inside, of mortar; the size of the asset.
std::vector<glm::vec4> finishBlock(const SceneBatch& batch) {
    static const FinishParameters mortar{
        .fineScale = 9.0f, .fineTone = 0.12f, .roughness = 0.95f, .fineHeight = 0.002f};
    const AssetFinish& finish = batch.finish;
    const FinishFrame& frame = finish.frame;
    std::vector<glm::vec4> block;
    const auto add = [&](const FinishParameters& parameters) {
        const auto packed = packedFinish(withCourses(parameters, finish.courses));
        block.insert(block.end(), packed.begin(), packed.end());
        block.emplace_back(glm::vec2(frame.courseOrigin), 0.0f, static_cast<float>(frame.grainAxis));
    };
    add(finishParameters(finish.outside, FinishSide::Outside));
    add(finishParameters(finish.inside, FinishSide::Inside));
    add(mortar);
    block.emplace_back(glm::vec3(wholeSize(*batch.geometry)), 0.0f);
    return block;
}

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

/// For the instances of the bound vertex array from `first` on.
void describeInstances(const GlBuffer& firstBodies, std::size_t first) {
    glBindBuffer(GL_ARRAY_BUFFER, firstBodies.id());
    glVertexAttribIPointer(6, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), at(first * sizeof(std::uint32_t)));
    glVertexAttribDivisor(6, 1);
}

void describeVertices(const GlBuffer& vertices, const GlBuffer& indices, const GlBuffer& firstBodies) {
    constexpr GLsizei kStride = sizeof(SceneVertex);
    glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(SceneVertex, position)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(SceneVertex, normal)));
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(SceneVertex, uv)));
    glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, kStride, at(offsetof(SceneVertex, solid)));
    glVertexAttribPointer(4, 2, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(SceneVertex, across)));
    glVertexAttribIPointer(5, 1, GL_UNSIGNED_BYTE, kStride, at(offsetof(SceneVertex, side)));
    glVertexAttribPointer(7, 1, GL_UNSIGNED_BYTE, GL_FALSE, kStride, at(offsetof(SceneVertex, sizeCode)));
    describeInstances(firstBodies, 0);
    for (GLuint attribute = 0; attribute <= 7; ++attribute) glEnableVertexAttribArray(attribute);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
}

}  // namespace

SceneBuffers::SceneBuffers()
    : m_poses(TextureUnit::Poses, GL_RGBA32F),
      m_previousPoses(TextureUnit::PreviousPoses, GL_RGBA32F),
      m_explodeOffsets(TextureUnit::ExplodeOffsets, GL_RGBA32F),
      m_appearances(TextureUnit::Appearances, GL_RGBA32UI),
      m_restOffsets(TextureUnit::RestOffsets, GL_RGBA32F) {}

const SceneBuffers::Geometry& SceneBuffers::uploaded(const std::shared_ptr<const SceneGeometry>& source) {
    const auto known = m_geometries.find(source.get());
    if (known != m_geometries.end()) return known->second;
    m_counts.geometryBytes += std::span(source->vertices).size_bytes() + std::span(source->indices).size_bytes();
    // The index buffer is created as an array buffer: an element buffer would become part of the bound vertex array.
    Geometry made{source, bufferOf(GL_ARRAY_BUFFER, source->vertices), bufferOf(GL_ARRAY_BUFFER, source->indices)};
    return m_geometries.emplace(source.get(), std::move(made)).first->second;
}

SceneBuffers::Batch SceneBuffers::batchOf(const SceneBatch& batch) {
    m_counts.geometryBytes += std::span(batch.firstBodies).size_bytes();
    Batch made{.firstBodies = bufferOf(GL_ARRAY_BUFFER, batch.firstBodies), .bodies = GlVertexArray::create()};
    const Geometry& geometry = uploaded(batch.geometry);
    made.meanPartSize = batch.geometry->meanPartSize();
    made.hasMortar = std::ranges::find(batch.geometry->vertices, VertexSide::Mortar, &SceneVertex::side) !=
                     batch.geometry->vertices.end();
    glBindVertexArray(made.bodies.id());
    describeVertices(geometry.vertices, geometry.indices, made.firstBodies);
    if (batch.hulls) {
        const Geometry& hulls = uploaded(batch.hulls);
        made.hulls = GlVertexArray::create();
        glBindVertexArray(made.hulls.id());
        describeVertices(hulls.vertices, hulls.indices, made.firstBodies);
    }
    glBindVertexArray(0);
    if (!batch.finish.isPlain() || batch.texture) made.finishes = bufferOf(GL_UNIFORM_BUFFER, finishBlock(batch));
    return made;
}

void SceneBuffers::uploadBatches() {
    m_batches.clear();
    std::unordered_set<const SceneGeometry*> used;
    for (const SceneBatch& batch : m_scene->batches) used.insert({batch.geometry.get(), batch.hulls.get()});
    std::erase_if(m_geometries, [&](const auto& geometry) { return !used.contains(geometry.first); });
    std::vector<SharedImage> images;
    for (const SceneBatch& batch : m_scene->batches)
        if (batch.texture) images.push_back(batch.texture);
    m_textures.setImages(std::move(images));
    for (const SceneBatch& batch : m_scene->batches) m_batches.push_back(batchOf(batch));
    m_hasFinishes = std::ranges::any_of(m_batches, [](const Batch& batch) { return batch.finishes.id() != 0; });
}

void SceneBuffers::findWholes(const SceneBatch& source, Batch& batch) const {
    batch.wholes.assign(source.firstBodies.size(), Whole::Never);
    const SceneGeometry& geometry = *source.geometry;
    const bool isExploded = !m_scene->explodeOffsets.empty() && m_scene->explodeFactor != 0.0;
    if (geometry.whole == SceneGeometry::Whole::None) return;
    for (std::size_t k = 0; k < batch.wholes.size(); ++k) {
        const auto bodies = std::span(m_scene->appearances).subspan(source.firstBodies[k], geometry.solidCount());
        const auto isHidden = [](const BodyAppearance& body) { return (body.marks & kHidden) != 0; };
        if (geometry.whole == SceneGeometry::Whole::Solid) {
            if (std::ranges::all_of(bodies.subspan(1), isHidden)) batch.wholes[k] = Whole::Always;
        } else if (!isExploded && std::ranges::all_of(bodies, [&](const auto& body) { return body == bodies[0]; })) {
            batch.wholes[k] = Whole::Equal;
        }
    }
}

void SceneBuffers::upload(std::shared_ptr<const RenderScene> scene) {
    if (scene == m_scene) return;
    const bool isNew = m_scene == nullptr || m_scene->batches != scene->batches;
    if (isNew && !isMemoryLeftFor(*scene)) throw std::bad_alloc();
    m_scene = std::move(scene);
    if (isNew) uploadBatches();
    if (m_hasFinishes && (isNew || m_scene->restOffsets != m_restSource)) {
        m_restSource = m_scene->restOffsets;
        const std::vector<glm::vec4> none(m_scene->poses.size(), glm::vec4(0.0f));
        m_restOffsets.write(std::as_bytes(std::span(m_restSource ? *m_restSource : none)));
    }
    const auto write = [&](TexelBuffer& texels, const auto& values) {
        if (values.empty()) return;
        texels.write(std::as_bytes(std::span(values)));
        m_counts.bodyBytes += std::span(values).size_bytes();
    };
    write(m_poses, m_scene->poses);
    write(m_previousPoses, m_scene->previousPoses);
    write(m_explodeOffsets, m_scene->explodeOffsets);
    write(m_appearances, m_scene->appearances);
    for (std::size_t k = 0; k < m_batches.size(); ++k) findWholes(m_scene->batches[k], m_batches[k]);
    sortInstances();
}

void SceneBuffers::setView(const InstanceView& view) {
    if (view == m_view) return;
    m_view = view;
    sortInstances();
}

void SceneBuffers::sortInstances() {
    const InstanceFilter filter(*m_scene, m_view);
    for (std::size_t k = 0; k < m_batches.size(); ++k) sortInstances(m_scene->batches[k], filter, m_batches[k]);
}

/// Only instances that move as one are tested for visibility.
void SceneBuffers::sortInstances(const SceneBatch& source, const InstanceFilter& filter, Batch& batch) {
    enum Group { kParts, kEqual, kWhole, kUnseen, kGroups };
    std::array<std::vector<std::uint32_t>, kGroups> groups;
    for (std::size_t k = 0; k < batch.wholes.size(); ++k) {
        const std::uint32_t first = source.firstBodies[k];
        Group group = kParts;
        if (batch.wholes[k] != Whole::Never) {
            const InstanceFilter::Sphere sphere = filter.sphereOf(first, source.geometry->wholeBox);
            const bool isSmall = filter.pixelsOf(batch.meanPartSize, sphere) < m_view.minFragmentPixels;
            const bool isWhole =
                batch.wholes[k] == Whole::Always || isSmall || (m_view.areCracksHidden && !batch.hasMortar);
            group = !filter.isSeen(sphere) ? kUnseen : isWhole ? kWhole : kEqual;
        }
        groups[group].push_back(first);
    }
    std::vector<std::uint32_t> order;
    for (int group = 0; group < kGroups; ++group) {
        if (group == kEqual) batch.equalBegin = order.size();
        if (group == kWhole) batch.wholeBegin = order.size();
        if (group == kUnseen) batch.unseenBegin = order.size();
        order.insert(order.end(), groups[group].begin(), groups[group].end());
    }
    if (order == batch.order) return;
    batch.order = std::move(order);
    glBindBuffer(GL_ARRAY_BUFFER, batch.firstBodies.id());
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(std::span(batch.order).size_bytes()),
                    batch.order.data());
}

/// Draws instances [begin, end) of the order, in calls that do not last long.
void SceneBuffers::drawInstances(const Batch& batch, const GlVertexArray& array, TriangleRange indices,
                                 std::size_t begin, std::size_t end) const {
    constexpr std::size_t kMaxIndices = 3 * 400'000;  // of a call: in software, a tenth of a second
    if (begin == end || indices.size() == 0) return;
    glBindVertexArray(array.id());
    const std::size_t instances = std::max<std::size_t>(1, kMaxIndices / indices.size());
    const std::size_t indexStep = instances > 1 ? indices.size() : kMaxIndices;
    for (std::size_t first = begin; first < end; first += instances) {
        describeInstances(batch.firstBodies, first);
        const std::size_t count = std::min(instances, end - first);
        for (std::size_t index = indices.begin; index < indices.end; index += indexStep) {
            if (m_interruption && !m_isInterrupted) m_isInterrupted = m_interruption();
            if (m_isInterrupted) return;
            const std::size_t drawn = std::min(indexStep, indices.end - index);
            glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(drawn), GL_UNSIGNED_INT,
                                    at(index * sizeof(std::uint32_t)), static_cast<GLsizei>(count));
            ++m_counts.drawCalls;
            m_counts.triangles += drawn / 3 * count;
        }
    }
}

void SceneBuffers::bindTexels() const {
    for (const TexelBuffer* texels : {&m_poses, &m_previousPoses, &m_explodeOffsets, &m_appearances}) texels->bind();
    if (m_hasFinishes) m_restOffsets.bind();
}

SceneBuffers::Batches SceneBuffers::kindOf(const SceneBatch& source) const {
    if (source.texture && m_textures.textureOf(source.texture) != 0) return Batches::Textured;
    return source.finish.isPlain() ? Batches::Plain : Batches::Finished;
}

void SceneBuffers::draw(Part part, Batches batches) const {
    bindTexels();
    for (std::size_t k = 0; k < m_batches.size(); ++k) {
        const SceneBatch& source = m_scene->batches[k];
        const Batch& batch = m_batches[k];
        if (batches != Batches::All && kindOf(source) != batches) continue;
        if (batches == Batches::Textured) bindTexture(m_textures.textureOf(source.texture));
        if (batches == Batches::Textured || batches == Batches::Finished)
            glBindBufferBase(GL_UNIFORM_BUFFER, kFinishesBlock, batch.finishes.id());
        const SceneGeometry& geometry = *source.geometry;
        const std::size_t all = batch.order.size();
        switch (part) {
            case Part::Hulls:
                if (source.hulls) drawInstances(batch, batch.hulls, {0, source.hulls->indices.size()}, 0, all);
                break;
            case Part::Silhouettes:
                drawInstances(batch, batch.bodies, geometry.partIndices(), 0, batch.equalBegin);
                drawInstances(batch, batch.bodies, geometry.silhouetteIndices, batch.equalBegin, all);
                break;
            case Part::Bodies:
                drawInstances(batch, batch.bodies, geometry.partIndices(), 0, batch.wholeBegin);
                drawInstances(batch, batch.bodies, geometry.wholeIndices, batch.wholeBegin, batch.unseenBegin);
        }
    }
    glBindVertexArray(0);
}

std::size_t SceneBuffers::bodyTriangles() const {
    std::size_t indices = 0;
    for (std::size_t k = 0; k < m_batches.size(); ++k) {
        const SceneGeometry& geometry = *m_scene->batches[k].geometry;
        const Batch& batch = m_batches[k];
        indices += geometry.partIndices().size() * batch.wholeBegin +
                   geometry.wholeIndices.size() * (batch.unseenBegin - batch.wholeBegin);
    }
    return indices / 3;
}

void SceneBuffers::drawBody(std::uint32_t body) const {
    bindTexels();
    for (std::size_t k = 0; k < m_batches.size(); ++k) {
        const SceneBatch& source = m_scene->batches[k];
        const std::vector<std::uint32_t>& order = m_batches[k].order;
        const auto isIts = [&](std::uint32_t first) { return body - first < source.geometry->solidCount(); };
        const auto found = std::ranges::find_if(order, isIts);
        if (found == order.end()) continue;
        const auto instance = static_cast<std::size_t>(found - order.begin());
        drawInstances(m_batches[k], m_batches[k].bodies, source.geometry->indicesOf(body - *found), instance,
                      instance + 1);
    }
    glBindVertexArray(0);
}

}  // namespace rubble
