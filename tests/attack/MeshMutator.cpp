#include "tests/attack/MeshMutator.h"

#include "core/io/system/AtomicFile.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSampleSize = 21000;  // bytes; the importer takes longer for larger ones

/// The ending of a file in lower case.
std::string endingOf(const fs::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return ending;
}

/// The names of files that a mesh must not reach; tests/attack/MeshFormat.cpp makes the first ones.
constexpr std::array kOutside = {"../outside.bin",
                                 "outside-link.bin",
                                 "outside-folder/outside.bin",
                                 "below/../../outside.bin",
                                 "./.././outside.bin",
                                 "%2e%2e/outside.bin",
                                 "..\\outside.bin",
                                 "/etc/passwd",
                                 "file:///etc/passwd",
                                 "../../../../../../../../etc/passwd",
                                 "/proc/self/environ",
                                 "/dev/zero",
                                 "."};

/// A triangle whose corners are in another file.
std::string gltfWithBuffer(const std::string& name) {
    return R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + name +
           R"(","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)"
           R"("componentType":5126,"count":3,"type":"VEC3"}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("images":[{"uri":")" +
           name + R"("}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
}

/// A triangle whose materials are in another file, or in this one if it is "mesh.obj": lines of both formats are read.
std::string objWithMaterials(const std::string& name) {
    return "mtllib " + name +
           "\nnewmtl Brick\nKa 0.1 0.1 0.1\nKd 0.6 0.15 0.1\nKs 0 0 0\nTf 1 1 1\nNs 10\nd 0.5\nNi 1.5\n" +
           "illum 2\nmap_Kd -o 1 1 1 -s 2 2 2 -clamp on " + name + "\nbump -bm 0.5 " + name + "\nPr 0.5\naniso 1\n" +
           "v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\no Wall\ng left\ns 1\nusemtl Brick\n" +
           "f 1/1/1 2/1/1 3/1/1\nl 1 2\np 1\nf -3//-1 -2//-1 -1//-1\n";
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

std::string bytesOf(std::uint32_t word) {
    std::string bytes(sizeof word, '\0');
    std::memcpy(bytes.data(), &word, sizeof word);
    return bytes;
}

// A GLB file: a header of 12 bytes, a chunk of JSON, a chunk of data; each chunk has a header of 8 bytes.
constexpr std::size_t kGlbJson = 20;

std::string jsonOfGlb(const std::string& glb) { return glb.substr(kGlbJson, wordAt(glb, 12)); }

bool isGlb2(const std::string& bytes) {
    return bytes.size() > kGlbJson && bytes.starts_with("glTF") && wordAt(bytes, 4) == 2 &&
           wordAt(bytes, 12) <= bytes.size() - kGlbJson;
}

std::string mutatedGlb(const std::string& glb, const JsonMutator& mutator, Random& random) {
    std::string json = mutator.mutated(random);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string data = glb.substr(kGlbJson + wordAt(glb, 12));
    if (random.below(3) == 0) data = mutatedBytes(data, random);
    return glb.substr(0, 8) + bytesOf(static_cast<std::uint32_t>(kGlbJson + json.size() + data.size())) +
           bytesOf(static_cast<std::uint32_t>(json.size())) + glb.substr(16, 4) + json + data;
}

/// A binary STL file: a header of 80 bytes, the number of triangles, 50 bytes for each.
std::string mutatedStl(std::string stl, Random& random) {
    constexpr std::size_t kCount = 80;
    if (stl.size() > kCount + 4 && random.below(3) == 0) {
        const std::uint32_t count = wordAt(stl, kCount);
        const std::array<std::uint32_t, 8> counts{0,         1,      count - 1,  count + 1,
                                                  2 * count, 100000, 0x7fffffff, 0xffffffff};
        stl.replace(kCount, 4, bytesOf(counts[random.below(counts.size())]));
    }
    return mutatedBytes(std::move(stl), random);
}

/// A binary PLY file: a header of lines, then data.
std::string mutatedPly(const std::string& ply, Random& random) {
    constexpr std::string_view kEnd = "end_header\n";
    const std::size_t found = ply.find(kEnd);
    if (found == std::string::npos || random.below(2) == 0) return mutatedBytes(ply, random);
    const std::size_t data = found + kEnd.size();
    std::string header = mutatedLines(ply.substr(0, data - 1), random);
    return header + ply.substr(data);
}

}  // namespace

std::vector<fs::path> meshFolders() {
    std::vector<fs::path> folders{fs::path(RUBBLE_SOURCE_DIR) / "tests/data/meshes"};
    for (const fs::path& root :
         {fs::path(RUBBLE_SOURCE_DIR) / "tests/corpus/MeshCases", fs::path("/usr/share/assimp/models")}) {
        if (!fs::is_directory(root)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root))
            if (entry.is_directory()) folders.push_back(entry.path());
    }
    std::ranges::sort(folders);
    return folders;
}

MeshMutator::MeshMutator(const std::string& ending) : m_ending(ending) {
    std::vector<fs::path> paths;
    for (const fs::path& folder : meshFolders()) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.is_regular_file() && endingOf(entry.path()) == ending && entry.file_size() <= kMaxSampleSize)
                paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    for (const fs::path& path : paths) add(*readFile(path));
    for (const char* name : kOutside) {
        if (ending == ".obj") add(objWithMaterials(name));
        if (ending == ".gltf") add(gltfWithBuffer(name));
    }
    if (ending == ".obj") add(objWithMaterials("mesh.obj"));
    if (ending == ".gltf") add(gltfWithBuffer("mesh.gltf"));
}

std::string MeshMutator::mutated(Random& random) const {
    const Sample& sample = m_samples[random.below(m_samples.size())];
    return random.below(4) == 0 ? mutatedBytes(sample.bytes, random) : structured(sample, random);
}

void MeshMutator::add(const std::string& bytes) {
    Sample sample{.bytes = bytes};
    const bool isGlb = m_ending == ".glb" && isGlb2(bytes);
    const std::string json = isGlb ? jsonOfGlb(bytes) : bytes;
    if ((isGlb || m_ending == ".gltf") && nlohmann::json::accept(json))
        sample.json = std::make_shared<const JsonMutator>(std::vector{json}, "");
    if (m_ending == ".fbx") sample.fbx = fbxDocument(bytes);
    m_samples.push_back(std::move(sample));
}

std::string MeshMutator::structured(const Sample& sample, Random& random) const {
    if (m_ending == ".glb" && sample.json) return mutatedGlb(sample.bytes, *sample.json, random);
    if (sample.json) return sample.json->mutated(random);
    if (sample.fbx) return fbxBytes(mutatedFbx(*sample.fbx, random));
    const bool isText = sample.bytes.find('\0') == std::string::npos;
    if (isText) return mutatedLines(sample.bytes, random);
    if (m_ending == ".stl") return mutatedStl(sample.bytes, random);
    return m_ending == ".ply" ? mutatedPly(sample.bytes, random) : mutatedBytes(sample.bytes, random);
}

}  // namespace rubble::attack
