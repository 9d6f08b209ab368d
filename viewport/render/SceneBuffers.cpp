#include "viewport/render/SceneBuffers.h"

#include "core/base/limits/SoftwareRendererNeeds.h"
#include "viewport/render/ImageDecoding.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
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

std::size_t bytesOf(const SceneGeometry& geometry) {
    return std::span(geometry.vertices).size_bytes() + std::span(geometry.indices).size_bytes();
}

/// What is uploaded of a scene, bytes, counting what several batches share once for each.
std::size_t geometryBytes(const RenderScene& scene) {
    std::size_t bytes = 0;
    for (const SceneBatch& batch : scene.batches) {
        bytes += bytesOf(*batch.geometry) + (batch.hulls ? bytesOf(*batch.hulls) : 0);
        if (batch.texture)
            bytes += std::size_t{8} * batch.texture->width() * batch.texture->height();  // decoded, twice
    }
    return bytes;
}

void bindTexture(std::uint32_t texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::BaseColour));
    glBindTexture(GL_TEXTURE_2D, texture);
}

/// An image that repeats, with all of its mipmaps.
GlTexture textureOf(const DecodedImage& image) {
    GlTexture texture = GlTexture::create();
    bindTexture(texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height), 0,
                 GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
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
      m_appearances(TextureUnit::Appearances, GL_RGBA32UI) {}

const SceneBuffers::Geometry& SceneBuffers::uploaded(const std::shared_ptr<const SceneGeometry>& source) {
    const auto known = std::ranges::find(m_geometries, source, &Geometry::source);
    if (known != m_geometries.end()) return *known;
    m_counts.geometryBytes += std::span(source->vertices).size_bytes() + std::span(source->indices).size_bytes();
    // The index buffer is created as an array buffer: an element buffer would become part of the bound vertex array.
    m_geometries.push_back(
        {source, bufferOf(GL_ARRAY_BUFFER, source->vertices), bufferOf(GL_ARRAY_BUFFER, source->indices)});
    return m_geometries.back();
}

std::uint32_t SceneBuffers::uploaded(const std::shared_ptr<const EncodedImage>& source) {
    const auto known = std::ranges::find(m_textures, source, &Texture::source);
    if (known != m_textures.end()) return known->texels.id();
    m_textures.push_back({source, {}});
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const std::optional<DecodedImage> image = decoded(*source, static_cast<std::uint32_t>(largest));
    if (image) m_textures.back().texels = textureOf(*image);
    return m_textures.back().texels.id();
}

SceneBuffers::Batch SceneBuffers::batchOf(const SceneBatch& batch) {
    m_counts.geometryBytes += std::span(batch.firstBodies).size_bytes();
    Batch made{.firstBodies = bufferOf(GL_ARRAY_BUFFER, batch.firstBodies),
               .bodies = GlVertexArray::create(),
               .inParts = batch.firstBodies.size()};
    if (batch.texture) made.texture = uploaded(batch.texture);
    const Geometry& geometry = uploaded(batch.geometry);
    glBindVertexArray(made.bodies.id());
    describeVertices(geometry.vertices, geometry.indices, made.firstBodies);
    if (batch.geometry->wholeIndices > 0) {
        made.wholeBodies = GlVertexArray::create();
        glBindVertexArray(made.wholeBodies.id());
        describeVertices(geometry.vertices, geometry.indices, made.firstBodies);
    }
    if (batch.hulls) {
        const Geometry& hulls = uploaded(batch.hulls);
        made.hulls = GlVertexArray::create();
        glBindVertexArray(made.hulls.id());
        describeVertices(hulls.vertices, hulls.indices, made.firstBodies);
    }
    glBindVertexArray(0);
    return made;
}

void SceneBuffers::uploadBatches() {
    m_batches.clear();
    const auto isUsed = [&](const Geometry& geometry) {
        return std::ranges::any_of(m_scene->batches, [&](const SceneBatch& batch) {
            return batch.geometry == geometry.source || batch.hulls == geometry.source;
        });
    };
    std::erase_if(m_geometries, [&](const Geometry& geometry) { return !isUsed(geometry); });
    std::erase_if(m_textures, [&](const Texture& texture) {
        return std::ranges::find(m_scene->batches, texture.source, &SceneBatch::texture) == m_scene->batches.end();
    });
    for (const SceneBatch& batch : m_scene->batches) m_batches.push_back(batchOf(batch));
}

/// Puts the instances that are whole last: all their solids but the first are hidden.
void SceneBuffers::sortInstances(const SceneBatch& source, Batch& batch) {
    if (source.geometry->wholeIndices == 0) return;
    const auto isPartHidden = [](const BodyAppearance& part) { return (part.marks & kHidden) != 0; };
    std::vector<std::uint8_t> isWhole;
    for (const std::uint32_t first : source.firstBodies) {
        const auto parts =
            std::span(m_scene->appearances).subspan(first + std::size_t{1}, source.geometry->solidCount() - 1);
        isWhole.push_back(std::ranges::all_of(parts, isPartHidden) ? 1 : 0);
    }
    if (isWhole == batch.isWhole) return;
    std::vector<std::uint32_t> sorted;
    const auto add = [&](bool whole) {
        for (std::size_t k = 0; k < isWhole.size(); ++k)
            if ((isWhole[k] != 0) == whole) sorted.push_back(source.firstBodies[k]);
    };
    add(false);
    batch.inParts = sorted.size();
    add(true);
    batch.isWhole = std::move(isWhole);
    glBindBuffer(GL_ARRAY_BUFFER, batch.firstBodies.id());
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(std::span(sorted).size_bytes()), sorted.data());
    glBindVertexArray(batch.wholeBodies.id());
    describeInstances(batch.firstBodies, batch.inParts);
    glBindVertexArray(0);
}

void SceneBuffers::upload(std::shared_ptr<const RenderScene> scene) {
    if (scene == m_scene) return;
    const bool isNew = m_scene == nullptr || m_scene->batches != scene->batches;
    if (isNew && !isRendererMemoryLeft(geometryBytes(*scene))) throw std::bad_alloc();
    m_scene = std::move(scene);
    if (isNew) uploadBatches();
    const auto write = [&](TexelBuffer& texels, const auto& values) {
        if (values.empty()) return;
        texels.write(std::as_bytes(std::span(values)));
        m_counts.bodyBytes += std::span(values).size_bytes();
    };
    write(m_poses, m_scene->poses);
    write(m_previousPoses, m_scene->previousPoses);
    write(m_explodeOffsets, m_scene->explodeOffsets);
    write(m_appearances, m_scene->appearances);
    for (std::size_t k = 0; k < m_batches.size(); ++k) sortInstances(m_scene->batches[k], m_batches[k]);
}

void SceneBuffers::draw(Part part, Batches batches) const {
    for (const TexelBuffer* texels : {&m_poses, &m_previousPoses, &m_explodeOffsets, &m_appearances}) texels->bind();
    for (std::size_t k = 0; k < m_batches.size(); ++k) {
        const SceneBatch& batch = m_scene->batches[k];
        const SceneGeometry* geometry = (part == Part::Hulls ? batch.hulls : batch.geometry).get();
        const std::uint32_t texture = m_batches[k].texture;
        const bool isOther = batches != Batches::All && (texture != 0) != (batches == Batches::Textured);
        if (geometry == nullptr || batch.firstBodies.empty() || isOther) continue;
        if (batches == Batches::Textured) bindTexture(texture);
        const auto drawInstances = [&](const GlVertexArray& bodies, std::size_t indices, std::size_t instances) {
            if (instances == 0) return;
            glBindVertexArray(bodies.id());
            glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(indices), GL_UNSIGNED_INT, nullptr,
                                    static_cast<GLsizei>(instances));
            ++m_counts.drawCalls;
            m_counts.triangles += indices / 3 * instances;
        };
        const std::size_t all = batch.firstBodies.size(), inParts = m_batches[k].inParts;
        if (part == Part::Hulls) {
            drawInstances(m_batches[k].hulls, geometry->indices.size(), all);
            continue;
        }
        drawInstances(m_batches[k].bodies, geometry->indices.size(), inParts);
        drawInstances(m_batches[k].wholeBodies, geometry->wholeIndices, all - inParts);
    }
    glBindVertexArray(0);
}

}  // namespace rubble
