#include "tests/attack/JsonTree.h"

#include <nlohmann/json.hpp>

namespace rubble::attack {
namespace {

JsonTree treeOfValue(const nlohmann::ordered_json& value) {
    JsonTree tree;
    if (value.is_object()) {
        tree.kind = JsonTree::Kind::Object;
        for (const auto& item : value.items())
            tree.children.emplace_back(nlohmann::ordered_json(item.key()).dump(), treeOfValue(item.value()));
    } else if (value.is_array()) {
        tree.kind = JsonTree::Kind::Array;
        for (const auto& element : value) tree.children.emplace_back(std::string(), treeOfValue(element));
    } else {
        tree.text = value.dump();
    }
    return tree;
}

void append(const JsonTree& tree, std::string& text) {
    if (tree.kind == JsonTree::Kind::Scalar) {
        text += tree.text;
        return;
    }
    const bool isObject = tree.kind == JsonTree::Kind::Object;
    text += isObject ? '{' : '[';
    bool isFirst = true;
    for (const auto& [key, child] : tree.children) {
        if (!isFirst) text += ',';
        isFirst = false;
        if (isObject) (text += key) += ':';
        append(child, text);
    }
    text += isObject ? '}' : ']';
}

}  // namespace

JsonTree treeOf(std::string_view json) { return treeOfValue(nlohmann::ordered_json::parse(json)); }

std::string textOf(const JsonTree& tree) {
    std::string text;
    append(tree, text);
    return text;
}

}  // namespace rubble::attack
