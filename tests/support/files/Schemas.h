#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rubble::test {

/// A JSON Schema of resources/schemas.
class Schema {
public:
    explicit Schema(const std::string& name);
    ~Schema();

    /// Returns path and reason if the JSON does not match; empty if it does.
    std::string fault(const nlohmann::json& json) const;

private:
    struct Compiled;
    std::unique_ptr<Compiled> m_compiled;
};

}  // namespace rubble::test
