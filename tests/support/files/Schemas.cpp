#include "tests/support/files/Schemas.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace rubble::test {

struct Schema::Compiled {
    valijson::Schema schema;
};

namespace {

nlohmann::json schemaFile(const std::string& name) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/resources/schemas/" + name);
    return nlohmann::json::parse(file);
}

}  // namespace

Schema::Schema(const std::string& name) : m_compiled(std::make_unique<Compiled>()) {
    const nlohmann::json json = schemaFile(name);
    // One schema may refer to parts of another, which lies beside it.
    const auto fetch = [](const std::string& uri) {
        return new nlohmann::json(schemaFile(uri.substr(uri.rfind('/') + 1)));
    };
    const auto free = [](const nlohmann::json* fetched) { delete fetched; };
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(json), m_compiled->schema, fetch,
                                            free);
}

Schema::~Schema() = default;

std::string Schema::fault(const nlohmann::json& json) const {
    valijson::ValidationResults results;
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    if (validator.validate(m_compiled->schema, valijson::adapters::NlohmannJsonAdapter(json), &results)) return {};
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
        for (const std::string& step : error.context) text += step;
        text += ": " + error.description + "\n";
    }
    return text.empty() ? "does not fit" : text;
}

}  // namespace rubble::test
