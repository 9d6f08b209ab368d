#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace rubble::test {

/// A JSON Schema of resources/schemas.
class Schema {
public:
    explicit Schema(const std::string& name) {
        std::ifstream file(RUBBLE_SOURCE_DIR "/resources/schemas/" + name);
        const nlohmann::json json = nlohmann::json::parse(file);
        valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(json), m_schema);
    }

    /// Where and why the JSON does not fit; empty where it does.
    std::string fault(const nlohmann::json& json) const {
        valijson::ValidationResults results;
        valijson::Validator validator(valijson::Validator::kStrongTypes);
        if (validator.validate(m_schema, valijson::adapters::NlohmannJsonAdapter(json), &results)) return {};
        std::string text;
        for (valijson::ValidationResults::Error error; results.popError(error);) {
            for (const std::string& step : error.context) text += step;
            text += ": " + error.description + "\n";
        }
        return text.empty() ? "does not fit" : text;
    }

private:
    valijson::Schema m_schema;
};

}  // namespace rubble::test
