#pragma once

#include "tests/support/Schemas.h"

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rubble::test {

/// A document with one thing wrong, and what is said of it.
struct JsonMutation {
    std::string name;   // what was done, for messages
    std::string place;  // "assets[2].prism.depth", as sentences begin
    nlohmann::json document;
};

namespace mutation {

using Json = nlohmann::json;

inline std::string placeOf(const Json::json_pointer& pointer, const Json& root) {
    std::string place;
    Json::json_pointer parent;
    std::vector<std::string> steps;
    for (Json::json_pointer rest = pointer; !rest.empty(); rest.pop_back()) steps.insert(steps.begin(), rest.back());
    for (const std::string& step : steps) {
        if (root.at(parent).is_array()) {
            place += "[" + step + "]";
        } else {
            place += (place.empty() ? "" : ".") + step;
        }
        parent.push_back(step);
    }
    return place.empty() ? "The document" : place;
}

/// A value of every type but the one that stands there.
inline std::vector<Json> otherTypes(const Json& value) {
    std::vector<Json> wrong;
    if (!value.is_null()) wrong.push_back(nullptr);
    if (!value.is_boolean()) wrong.push_back(true);
    if (!value.is_string()) wrong.push_back("word");
    if (!value.is_number()) wrong.push_back(1.5);
    if (!value.is_object()) wrong.push_back(Json::object());
    if (!value.is_array()) wrong.push_back(Json::array({Json::array()}));
    return wrong;
}

inline void forEachPlace(const Json& value, Json::json_pointer at,
                         const std::function<void(const Json&, const Json::json_pointer&)>& visit) {
    visit(value, at);
    if (value.is_object())
        for (const auto& [key, child] : value.items()) forEachPlace(child, at / key, visit);
    if (value.is_array())
        for (std::size_t k = 0; k < value.size(); ++k) forEachPlace(value[k], at / k, visit);
}

}  // namespace mutation

/// Every value replaced by one of every other type, every key left out, and one more in every object. `fits` tells
/// values that are as good at a place.
inline std::vector<JsonMutation> mutationsOf(
    const nlohmann::json& document,
    const std::function<bool(const std::string& place, const nlohmann::json& value)>& fits) {
    using mutation::Json;
    std::vector<JsonMutation> mutations;
    const auto add = [&](const std::string& what, const Json::json_pointer& at, const Json& value) {
        Json changed = document;
        changed[at] = value;
        mutations.push_back({at.to_string() + what, mutation::placeOf(at, document), std::move(changed)});
    };
    mutation::forEachPlace(document, Json::json_pointer(), [&](const Json& value, const Json::json_pointer& at) {
        const std::string place = mutation::placeOf(at, document);
        for (const Json& other : mutation::otherTypes(value)) {
            if (!fits(place, other)) add(" = " + other.dump(), at, other);
        }
        if (!value.is_object()) return;
        for (const auto& item : value.items()) {
            Json less = value;
            less.erase(item.key());
            add(" without " + item.key(), at, less);
        }
        Json more = value;
        more["colour scheme"] = 1;
        add(" with one more key", at, more);
    });
    return mutations;
}

/// A document with another value at a place, as text.
inline std::string changedText(nlohmann::json document, const std::string& pointer, const std::string& value) {
    document[nlohmann::json::json_pointer(pointer)] = nlohmann::json::parse(value);
    return document.dump();
}

/// Which of a document's mutations its reader or its schema lets pass, or tells with another place; empty where none.
/// `faultOf` reads a text and says what is wrong with it.
inline std::string untoldMutation(
    const nlohmann::json& document, const Schema& schema,
    const std::function<bool(const std::string& place, const nlohmann::json& value)>& fits,
    const std::function<std::string(std::string_view)>& faultOf) {
    for (const JsonMutation& mutation : mutationsOf(document, fits)) {
        const std::string fault = faultOf(mutation.document.dump());
        if (!fault.starts_with(mutation.place + ": ")) return mutation.name + " gives: " + fault;
        if (schema.fault(mutation.document).empty()) return mutation.name + " fits the schema";
    }
    return {};
}

}  // namespace rubble::test
