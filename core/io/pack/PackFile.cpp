#include "core/io/pack/PackFile.h"

#include "core/base/Parallel.h"
#include "core/io/pack/PackBodyJson.h"
#include "core/io/pack/PackBondingJson.h"
#include "core/io/pack/PackHeaderJson.h"

namespace rubble {
namespace {

constexpr std::size_t kChunk = 64;  // bodies of a task

/// Returns the fragments from `first` on, at most kChunk, as a JSON array.
std::string chunkJson(const PackBuilder& builder, PackTopology topology, std::size_t first) {
    std::vector<PackBody> bodies;
    const std::size_t end = std::min(first + kChunk, std::size_t{builder.fragmentCount()});
    bodies.reserve(end - first);
    std::size_t size = 0;
    for (auto k = static_cast<std::uint32_t>(first); k < end; ++k) {
        bodies.push_back(builder.fragment(k));
        size += packBodySize(bodies.back());
    }
    JsonWriter json(JsonLayout::CompactLines, size);
    json.openArray();
    for (const PackBody& body : bodies) writePackBody(json, {}, body, topology);
    json.close();
    return std::move(json).contents();
}

}  // namespace

std::string packJson(const PackBuilder& builder, std::span<const PackMeshFile> meshes, PackTopology topology,
                     const TaskContext& task) {
    const PackBody whole = builder.whole();
    std::vector<std::string> chunks((builder.fragmentCount() + kChunk - 1) / kChunk);
    forEachIndex(chunks.size(), task.threads,
                 [&](std::size_t k) { chunks[k] = chunkJson(builder, topology, kChunk * k); });

    std::size_t size = 4096 + packBodySize(whole) + 256 * meshes.size();
    for (const std::string& chunk : chunks) size += chunk.size();
    JsonWriter json(JsonLayout::CompactLines, size);
    json.openObject();
    writePackHeader(json, builder.header(meshes));
    writePackBody(json, "whole", whole, topology);
    json.openArray("fragments", JsonLayout::CompactLines);
    for (const std::string& chunk : chunks) json.elements(chunk);
    json.close();
    if (const std::optional<PackBonding> bonding = builder.bonding()) writePackBonding(json, *bonding);
    json.close();
    return withChecksum(std::move(json).finished());
}

}  // namespace rubble
