#pragma once

#include <QString>

#include <cstdint>
#include <string>

namespace rubble {

/// A fault, with the random seed that reproduces it.
inline QString faultOfSeed(std::uint64_t seed, const std::string& fault) {
    return QString("seed %1: %2").arg(seed).arg(QString::fromStdString(fault));
}

}  // namespace rubble
