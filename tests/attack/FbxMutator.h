#pragma once

#include "core/base/Random.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble::attack {

/// A node of a binary FBX file.
struct FbxNode {
    std::string name;
    std::vector<std::string> properties;  // as in the file: a letter for the type, then the value
    std::vector<FbxNode> children;
};

/// A binary FBX file.
struct FbxDocument {
    std::string header;  // 27 bytes, the last four of which are the version
    std::vector<FbxNode> nodes;
    std::string footer;
};

/// Returns the nodes of a file; nothing if it is not binary FBX.
std::optional<FbxDocument> fbxDocument(const std::string& bytes);
std::string fbxBytes(const FbxDocument& document);

/// Changes one to four nodes: values, sizes and elements of arrays, texts, names, missing, repeated, moved or deeply
/// nested nodes. `document` has nodes.
FbxDocument mutatedFbx(FbxDocument document, Random& random);

}  // namespace rubble::attack
