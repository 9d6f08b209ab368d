#include "tests/support/Schemas.h"

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

Schema::Schema(const std::string& name) : m_compiled(std::make_unique<Compiled>()) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/resources/schemas/" + name);
    const nlohmann::json json = nlohmann::json::parse(file);
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(json), m_compiled->schema);
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
