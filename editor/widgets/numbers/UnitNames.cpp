#include "editor/widgets/numbers/UnitNames.h"

#include <algorithm>
#include <span>
#include <vector>

namespace rubble {

namespace {

/// A unit with its names, the first of which messages use. Its size is multiple / 10^exponent in the unit stored.
struct UnitOfFamily {
    const char* names;  // separated by blanks
    quint64 multiple;
    int exponent;
};

// Sizes of feet, inches, pounds and their like are exact by the agreement of 1959, to the digits given here else.
constexpr UnitOfFamily kLengths[] = {{"m metre metres meter meters", 1, 0},
                                     {"cm", 1, 2},
                                     {"mm", 1, 3},
                                     {"µm um", 1, 6},
                                     {"dm", 1, 1},
                                     {"km", 1, -3},
                                     {"ft ' ′ foot feet", 3048, 4},
                                     {"in \" ″ '' ′′ inch inches", 254, 4},
                                     {"yd", 9144, 4}};
constexpr UnitOfFamily kAreas[] = {
    {"m²", 1, 0}, {"cm²", 1, 4}, {"mm²", 1, 6}, {"dm²", 1, 2}, {"ft² sqft", 9290304, 8}, {"in² sqin", 64516, 8}};
constexpr UnitOfFamily kVolumes[] = {{"m³", 1, 0},    {"cm³ cc ccm ml", 1, 6},       {"mm³", 1, 9},
                                     {"dm³ l", 1, 3}, {"ft³ cuft", 28316846592, 12}, {"in³ cuin", 16387064, 12}};
constexpr UnitOfFamily kMasses[] = {
    {"kg", 1, 0}, {"g", 1, 3}, {"mg", 1, 6}, {"t", 1, -3}, {"lb lbs", 45359237, 8}, {"oz", 28349523125, 12}};
constexpr UnitOfFamily kDensities[] = {
    {"kg/m³", 1, 0}, {"g/cm³ g/ml kg/l kg/dm³ t/m³", 1, -3}, {"lb/ft³ pcf", 1601846337396014, 14}};
constexpr UnitOfFamily kTimes[] = {{"s sec", 1, 0}, {"ms", 1, 3}, {"µs us", 1, 6}, {"min", 60, 0}, {"h", 3600, 0}};
constexpr UnitOfFamily kSpeeds[] = {{"m/s", 1, 0},         {"cm/s", 1, 2},
                                    {"mm/s", 1, 3},        {"km/h kmh kph", 2777777777777778, 16},
                                    {"ft/s fps", 3048, 4}, {"mph", 44704, 5}};
constexpr UnitOfFamily kAccelerations[] = {{"m/s²", 1, 0}, {"cm/s²", 1, 2}, {"ft/s²", 3048, 4}, {"g", 980665, 5}};
constexpr UnitOfFamily kForces[] = {
    {"N", 1, 0}, {"kN", 1, -3}, {"MN", 1, -6}, {"lbf", 44482216152605, 13}, {"kgf", 980665, 5}};
constexpr UnitOfFamily kEnergies[] = {
    {"J N·m Ws", 1, 0}, {"kJ", 1, -3}, {"MJ", 1, -6}, {"Wh", 3600, 0}, {"ft·lbf", 13558179483314004, 16}};
constexpr UnitOfFamily kImpulses[] = {{"N·s kg·m/s", 1, 0}, {"kN·s", 1, -3}, {"lbf·s", 44482216152605, 13}};
constexpr UnitOfFamily kImpulsesPerArea[] = {
    {"N·s/m² Pa·s", 1, 0}, {"kN·s/m² kPa·s", 1, -3}, {"N·s/cm²", 1, -4}, {"psi·s", 6894757293168361, 12}};
constexpr UnitOfFamily kPressures[] = {{"Pa N/m²", 1, 0},     {"kPa kN/m²", 1, -3}, {"MPa N/mm² MN/m²", 1, -6},
                                       {"GPa kN/mm²", 1, -9}, {"bar", 1, -5},       {"psi", 6894757293168361, 12}};
constexpr UnitOfFamily kToughnesses[] = {{"Pa√m", 1, 0}, {"kPa√m", 1, -3}, {"MPa√m", 1, -6}};
constexpr UnitOfFamily kAngles[] = {{"° deg degree degrees", 1, 0}, {"rad", 5729577951308232, 14}};
constexpr UnitOfFamily kPerLength[] = {{"perm /m 1/m", 1, 0},
                                       {"percm /cm 1/cm", 1, -2},
                                       {"permm /mm 1/mm", 1, -3},
                                       {"perft /ft 1/ft", 3280839895013123, 15}};
constexpr UnitOfFamily kFractions[] = {{"% percent", 1, 2}, {"‰", 1, 3}};

std::span<const UnitOfFamily> unitsOf(UnitFamily family) {
    switch (family) {
        case UnitFamily::None: return {};
        case UnitFamily::Length: return kLengths;
        case UnitFamily::Area: return kAreas;
        case UnitFamily::Volume: return kVolumes;
        case UnitFamily::Mass: return kMasses;
        case UnitFamily::Density: return kDensities;
        case UnitFamily::Time: return kTimes;
        case UnitFamily::Speed: return kSpeeds;
        case UnitFamily::Acceleration: return kAccelerations;
        case UnitFamily::Force: return kForces;
        case UnitFamily::Energy: return kEnergies;
        case UnitFamily::Impulse: return kImpulses;
        case UnitFamily::ImpulsePerArea: return kImpulsesPerArea;
        case UnitFamily::Pressure: return kPressures;
        case UnitFamily::Toughness: return kToughnesses;
        case UnitFamily::Angle: return kAngles;
        case UnitFamily::PerLength: return kPerLength;
        case UnitFamily::Fraction: return kFractions;
    }
    return {};
}

QStringList namesOf(const UnitOfFamily& unit) { return QString::fromUtf8(unit.names).split(' '); }

/// The name as units are compared: without blanks and product signs, powers as raised digits.
QString normalized(const QString& name) {
    static const std::pair<QString, QString> kSpellings[] = {{"sqrt(m)", "√m"}, {"m^0.5", "√m"}, {"^2", "²"},
                                                             {"^3", "³"},       {"2", "²"},      {"3", "³"},
                                                             {"μ", "µ"},        {"sq.", "sq"},   {"cu.", "cu"}};
    QString result = name;
    for (const auto& [written, standard] : kSpellings) result.replace(written, standard);
    result.removeIf([](QChar letter) { return letter.isSpace() || QStringLiteral("·⋅*").contains(letter); });
    return result;
}

/// True if both differ by upper and lower case at most, but not by that of a prefix: a mN is no MN.
bool isSameName(const QString& name, const QString& known, Qt::CaseSensitivity sensitivity) {
    if (name.compare(known, sensitivity) != 0) return false;
    return name.size() <= 1 || name[0] == known[0] || name[0].toLower() != 'm';
}

}  // namespace

std::optional<NumberFormat> unitNamed(UnitFamily family, const QString& name) {
    const QString wanted = normalized(name);
    for (const Qt::CaseSensitivity sensitivity : {Qt::CaseSensitive, Qt::CaseInsensitive}) {
        for (const UnitOfFamily& unit : unitsOf(family)) {
            const QStringList names = namesOf(unit);
            const bool isWanted = std::ranges::any_of(
                names, [&](const QString& known) { return isSameName(wanted, normalized(known), sensitivity); });
            if (isWanted) return NumberFormat{names.front(), unit.exponent, family, unit.multiple};
        }
    }
    return std::nullopt;
}

QStringList unitNames(UnitFamily family) {
    QStringList names;
    for (const UnitOfFamily& unit : unitsOf(family)) {
        QString name = namesOf(unit).front();
        if (name.startsWith("per")) name.insert(3, ' ');
        names << name;
    }
    return names;
}

}  // namespace rubble
