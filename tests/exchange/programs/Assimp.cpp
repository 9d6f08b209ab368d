// Prints what assimp reads of a mesh file, as a line of JSON: the names of nodes with meshes, and their triangles.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <cstdio>

namespace {

/// The triangles of a node's meshes, in the frame of the scene.
void printTriangles(const aiScene& scene, const aiNode& node, const aiMatrix4x4& toScene) {
    bool isFirst = true;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            std::printf("%s[", isFirst ? "" : ",");
            isFirst = false;
            for (unsigned k = 0; k < 3; ++k) {
                const aiVector3D p = toScene * mesh.mVertices[mesh.mFaces[f].mIndices[k]];
                std::printf("%s[%.9g,%.9g,%.9g]", k == 0 ? "" : ",", double(p.x), double(p.y), double(p.z));
            }
            std::printf("]");
        }
    }
}

void print(const aiScene& scene, const aiNode& node, const aiMatrix4x4& toParent, bool& isFirst) {
    const aiMatrix4x4 toScene = toParent * node.mTransformation;
    if (node.mNumMeshes > 0) {
        std::printf("%s{\"name\":\"%s\",\"triangles\":[", isFirst ? "" : ",", node.mName.C_Str());
        printTriangles(scene, node, toScene);
        std::printf("]}");
        isFirst = false;
    }
    for (unsigned k = 0; k < node.mNumChildren; ++k) print(scene, *node.mChildren[k], toScene, isFirst);
}

}  // namespace

int main(int count, char** arguments) {
    Assimp::Importer importer;
    const aiScene* scene = count == 2 ? importer.ReadFile(arguments[1], aiProcess_Triangulate) : nullptr;
    if (!scene) {
        std::fprintf(stderr, "%s\n", count == 2 ? importer.GetErrorString() : "usage: FILE");
        return 1;
    }
    bool isFirst = true;
    std::printf("[");
    print(*scene, *scene->mRootNode, aiMatrix4x4(), isFirst);
    std::printf("]\n");
}
