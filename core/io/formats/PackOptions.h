#pragma once

#include "core/geometry/hull/InsetHull.h"
#include "core/io/exchange/ObjFile.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace rubble {

/// The distribution of fragments among mesh files.
enum class FileSplit {
    Single,       // the leaf fragments in one file, the broken fragments of each level in another
    PerFragment,  // one file per fragment
};

/// The faces of an OBJ file. GLB files always have triangles.
enum class FaceShape { Polygons, Triangles };

enum class GlbKind {
    Plain,
    Physics,  // with rigid bodies, and the hulls of the pack as colliders
    Compact,  // small and drawn at once, see compactGlbFile()
    Named,    // with the hulls as meshes whose names Unreal Engine reads
};

/// The files that describe the bodies.
enum class PackFiles { Json, Binary, Both };

/// What is written of the hulls beside vertices and faces.
enum class PackTopology {
    Full,   // edges, signed edges and planes, which follow from vertices and faces
    Loops,  // nothing
};

/// The images of the surfaces in mesh files.
enum class SurfaceTextures {
    None,   // only those that were imported
    Baked,  // of the finishes of materials, see bakedTextures()
};

/// The side of the images that are baked.
enum class TextureSize { Texels512, Texels1024, Texels2048, Texels4096 };
inline int texelsOf(TextureSize size) { return 512 << static_cast<int>(size); }

/// The words of rows of exportFormats(), ascending.
class FormatSet {
public:
    FormatSet() = default;
    FormatSet(std::initializer_list<std::string_view> words) {
        for (const std::string_view word : words) insert(word);
    }
    bool contains(std::string_view word) const { return std::ranges::binary_search(m_words, word); }
    void insert(std::string_view word) {
        if (!contains(word)) m_words.insert(std::ranges::upper_bound(m_words, word), word);
    }
    void erase(std::string_view word) { std::erase(m_words, word); }
    auto begin() const { return m_words.begin(); }
    auto end() const { return m_words.end(); }
    bool operator==(const FormatSet&) const = default;

private:
    std::vector<std::string_view> m_words;
};

/// The mesh files that an export writes, and the options of their formats.
struct MeshOptions {
    FormatSet formats = {"obj", "glb"};
    FileSplit split = FileSplit::Single;
    PartPlacement place = PartPlacement::Assembled;
    FaceShape faces = FaceShape::Polygons;
    ObjFrame objFrame;
    GlbKind glbKind = GlbKind::Plain;
    SurfaceTextures textures = SurfaceTextures::None;
    TextureSize textureSize = TextureSize::Texels2048;
    bool operator==(const MeshOptions&) const = default;
};

/// The files of an export.
struct PackOptions {
    PackFiles files = PackFiles::Both;
    MeshOptions meshes;
    double inset = kDefaultInset;  // m, >= 0: of collision hulls
    PackTopology topology = PackTopology::Full;
    bool hasShortNames = false;  // of at most kShortestName bytes
    bool operator==(const PackOptions&) const = default;
};

}  // namespace rubble
