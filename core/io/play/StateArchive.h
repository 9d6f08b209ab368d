#pragma once

#include "core/base/Result.h"
#include "core/geometry/hull/MassProperties.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace rubble {

template <class T>
concept StateNumber = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

/// Writes or reads a struct field by field, by one function each that both archives call: visitFields(struct, archive),
/// which is a static member where the fields are private. `Self` is T or const T.
template <class T, class Self, class Archive>
void visitAllFields(Self& self, Archive& archive) {
    if constexpr (requires { T::visitFields(self, archive); }) {
        T::visitFields(self, archive);
    } else {
        visitFields(self, archive);
    }
}

static_assert(std::endian::native == std::endian::little);  // numbers are little-endian in files

/// Appends fields to bytes.
class StateWriter {
public:
    /// `absent`: the names of fields that are not written, since the version that is written does not have them.
    explicit StateWriter(std::span<const std::string_view> absent = {}) : m_absent(absent) {}

    template <class T>
    void operator()(const char* name, const T& field) {
        if (std::ranges::find(m_absent, name) == m_absent.end()) write(field);
    }
    std::string take() { return std::move(m_bytes); }

private:
    void append(const void* data, std::size_t size) { m_bytes.append(static_cast<const char*>(data), size); }

    template <StateNumber T>
    void write(T value) {
        append(&value, sizeof(value));
    }
    void write(bool value) { write(static_cast<std::uint8_t>(value)); }
    template <class T>
    requires std::is_enum_v<T>
    void write(T value) { write(static_cast<std::underlying_type_t<T>>(value)); }
    void write(const Vec2& v) { writeAll(v.x, v.y); }
    void write(const Vec3& v) { writeAll(v.x, v.y, v.z); }
    void write(const glm::vec3& v) { writeAll(v.x, v.y, v.z); }
    void write(const Quat& q) { writeAll(q.x, q.y, q.z, q.w); }
    template <class... Values>
    void writeAll(const Values&... values) {
        (write(values), ...);
    }
    void write(const std::string& text) {
        write(std::uint64_t{text.size()});
        append(text.data(), text.size());
    }
    template <class T, std::size_t N>
    void write(const std::array<T, N>& values) {
        writeElements(std::span<const T>(values));
    }
    template <class T>
    void write(const std::vector<T>& values) {
        write(std::uint64_t{values.size()});
        if constexpr (std::is_same_v<T, bool>) {
            for (const bool value : values) write(value);
        } else {
            writeElements(std::span<const T>(values));
        }
    }
    template <class T>
    void writeElements(std::span<const T> values) {
        if constexpr (StateNumber<T>) {
            append(values.data(), values.size_bytes());
        } else {
            for (const T& value : values) write(value);
        }
    }
    template <class T>
    void write(const std::optional<T>& value) {
        write(value.has_value());
        if (value) write(*value);
    }
    template <class Key, class T>
    void write(const std::map<Key, T>& values) {
        write(std::uint64_t{values.size()});
        for (const auto& [key, value] : values) writeAll(key, value);
    }
    template <class... Ts>
    void write(const std::variant<Ts...>& value) {
        write(static_cast<std::uint8_t>(value.index()));
        std::visit([this](const auto& one) { this->write(one); }, value);
    }
    template <class T>
    requires std::is_class_v<T>
    void write(const T& fields) { visitAllFields<T>(fields, *this); }

    std::string m_bytes;
    std::span<const std::string_view> m_absent;
};

/// Reads the fields that a StateWriter wrote, from bytes that may be anything. After the first fault nothing more is
/// read: of what follows, numbers are 0 and tables empty, and arrays of numbers stay as they were.
class StateReader {
public:
    /// `absent`: the names of fields that the bytes do not have, since they are of an older version.
    explicit StateReader(std::string_view bytes, std::span<const std::string_view> absent = {})
        : m_bytes(bytes), m_absent(absent) {}

    template <class T>
    void operator()(const char* name, T& field) {
        if (std::ranges::find(m_absent, name) != m_absent.end()) return;
        m_place.push_back({name, kNoElement});
        read(field);
        m_place.pop_back();
    }
    /// Must be called after the last field.
    void finish() {
        if (!m_fault && m_at != m_bytes.size()) fail("has bytes behind its end");
    }
    /// The first fault, after its place: "world.bodies[3].mass is not finite".
    const std::optional<std::string>& fault() const { return m_fault; }

private:
    static constexpr std::size_t kNoElement = static_cast<std::size_t>(-1);
    struct Place {
        const char* name;
        std::size_t element;
    };

    void fail(const std::string& what);
    std::size_t left() const { return m_bytes.size() - m_at; }
    bool copy(void* to, std::size_t size);
    /// The size of a table whose elements take at least a byte each; 0 if that many bytes are not there.
    std::size_t readSize(std::size_t elementBytes = 1);

    template <StateNumber T>
    void read(T& value) {
        value = {};
        if (!copy(&value, sizeof(value))) return;
        if constexpr (std::is_floating_point_v<T>) checkFinite(std::span<const T>(&value, 1));
    }
    void read(bool& value) {
        std::uint8_t octet = 0;
        read(octet);
        if (octet > 1) fail("is neither 0 nor 1");
        value = octet == 1;
    }
    template <class T>
    requires std::is_enum_v<T>
    void read(T& value) {
        std::underlying_type_t<T> number{};
        read(number);
        value = static_cast<T>(number);
    }
    void read(Vec2& v) { readAll(v.x, v.y); }
    void read(Vec3& v) { readAll(v.x, v.y, v.z); }
    void read(glm::vec3& v) { readAll(v.x, v.y, v.z); }
    void read(Quat& q) { readAll(q.x, q.y, q.z, q.w); }
    template <class... Values>
    void readAll(Values&... values) {
        (read(values), ...);
    }
    void read(std::string& text) {
        text.assign(readSize(), '\0');
        copy(text.data(), text.size());
    }
    template <class T, std::size_t N>
    void read(std::array<T, N>& values) {
        readElements(std::span<T>(values));
    }
    template <class T>
    void read(std::vector<T>& values) {
        const std::size_t size = readSize(StateNumber<T> ? sizeof(T) : 1);
        values.clear();
        if constexpr (StateNumber<T>) {
            values.resize(size);
            readElements(std::span<T>(values));
        } else {
            for (std::size_t k = 0; k < size && !m_fault; ++k) {
                T value{};
                m_place.back().element = k;
                read(value);
                values.push_back(std::move(value));
            }
            m_place.back().element = kNoElement;
        }
    }
    template <class T>
    void readElements(std::span<T> values) {
        if constexpr (StateNumber<T>) {
            if (!copy(values.data(), values.size_bytes())) return;
            if constexpr (std::is_floating_point_v<T>) checkFinite(std::span<const T>(values));
        } else {
            for (T& value : values) read(value);
        }
    }
    template <class T>
    void read(std::optional<T>& value) {
        bool isThere = false;
        read(isThere);
        value.reset();
        if (isThere) read(value.emplace());
    }
    template <class Key, class T>
    void read(std::map<Key, T>& values) {
        const std::size_t size = readSize();
        values.clear();
        for (std::size_t k = 0; k < size && !m_fault; ++k) {
            Key key{};
            T value{};
            m_place.back().element = k;
            readAll(key, value);
            if (!values.empty() && !(values.rbegin()->first < key)) fail("is not in ascending order");
            values.emplace_hint(values.end(), std::move(key), std::move(value));
        }
        m_place.back().element = kNoElement;
    }
    template <class... Ts>
    void read(std::variant<Ts...>& value) {
        std::uint8_t index = 0;
        read(index);
        if (index >= sizeof...(Ts)) return fail("is of an unknown kind");
        std::size_t k = 0;
        ((k++ == index ? read(value.template emplace<Ts>()) : void()), ...);
    }
    template <class T>
    requires std::is_class_v<T>
    void read(T& fields) { visitAllFields<T>(fields, *this); }
    template <class T>
    void checkFinite(std::span<const T> values) {
        for (const T value : values) {
            if (!std::isfinite(value)) return fail("is not finite");
        }
    }

    std::string_view m_bytes;
    std::span<const std::string_view> m_absent;
    std::size_t m_at = 0;
    std::vector<Place> m_place;
    std::optional<std::string> m_fault;
};

}  // namespace rubble
