#include "editor/panels/LayerRows.h"

#include "editor/commands/LayerKind.h"

#include <algorithm>
#include <numbers>

namespace rubble {

namespace {

constexpr double kStepOfShare = 0.05;

/// What is shown for one radian, metre or 1.
double shownPer(const LayerParameter& parameter) {
    return parameter.quantity == Quantity::Angle ? 180.0 / std::numbers::pi : 1.0;
}

FieldRange fieldRange(const LayerParameter& parameter) {
    const ParameterRange& range = parameter.range;
    const double factor = shownPer(parameter);
    FieldRange field{.min = range.min, .max = range.max, .isMinOut = range.isMinOut};
    if (factor != 1.0)
        field = {.min = std::round(range.min * factor), .max = std::round(range.max * factor), .step = 1.0};
    if (parameter.type == ParameterType::Whole) field = FieldRange::whole(range.min, range.max);
    if (range.min == 0.0 && range.max == 1.0 && !field.isWhole) field.step = kStepOfShare;
    return field;
}

auto numberOf(const LayerParameter& parameter) {
    return [&parameter, factor = shownPer(parameter)](const PatternLayer& layer) {
        return std::get<double>(parameter.read(layer.parameters)) * factor;
    };
}

auto settingNumber(const LayerParameter& parameter) {
    return [&parameter, factor = shownPer(parameter)](PatternLayer& layer, double entered) {
        const double value = std::clamp(entered / factor, parameter.range.min, parameter.range.max);
        parameter.write(layer.parameters, value);
    };
}

SeedCount countOf(const LayerParameter& parameter, const PatternLayer& layer) {
    return std::get<SeedCount>(parameter.read(layer.parameters));
}

/// As many seeds, or nearly, told in another way.
SeedCount converted(const SeedCount& count, CountBy by, double area) {
    if (count.by == by) return count;
    const double number = std::clamp(count.in(area), 1.0, static_cast<double>(kMostSeeds));
    switch (by) {
        case CountBy::Number: break;
        case CountBy::Density: return {by, number / area};
        case CountBy::PieceSize: return {by, std::sqrt(area / number)};
    }
    return {by, number};
}

}  // namespace

LayerRows::LayerRows(const PatternKind& kind, Document& document, const LayerForm::Chosen& chosen,
                     const LayerForm::Push& push, QWidget* parent)
    : Section(parent), m_kind(kind), m_form(document, chosen, push) {
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault(
        [](const PatternLayer& layer) { return QString::fromStdString(verifyPattern(Pattern{{layer}}).value_or("")); });
    for (const LayerParameter& parameter : kind.parameters) addParameter(parameter);
}

void LayerRows::addParameter(const LayerParameter& parameter) {
    const QString step = tr("Set %1").arg(patternText(parameter.caption).toLower());
    QWidget* row = nullptr;
    switch (parameter.type) {
        case ParameterType::Whole:
        case ParameterType::Real: row = addNumber(parameter, step); break;
        case ParameterType::Choice: row = addChoice(parameter, step); break;
        case ParameterType::Point: return addPoint(parameter, step);
        case ParameterType::Count: return addCount(parameter, step);
    }
    if (!parameter.isUsed) return;
    m_showUsed.push_back(
        [this, row, &parameter](const PatternLayer& layer) { setRowVisible(row, parameter.isUsed(layer.parameters)); });
}

template <class Control, class Read, class Write>
void LayerRows::bindNumber(Control* control, Quantity quantity, const QString& step, Read read, Write write) {
    m_form.bind(control, step, read, write);
    if (quantity == Quantity::Angle) control->setFormat({QStringLiteral("°"), 0});
    if (quantity == Quantity::Length) {
        m_takeUnits.push_back([control](const Units& units) { control->setFormat(units.lengths()); });
    }
}

QWidget* LayerRows::addNumber(const LayerParameter& parameter, const QString& step) {
    const QString caption = patternText(parameter.caption), hint = patternText(parameter.hint);
    const UsualRange& usual = parameter.usual;
    const double factor = shownPer(parameter);
    if (usual.from == usual.to) {
        auto* field = addRow(caption, new NumberField, hint);
        field->setRange(fieldRange(parameter));
        bindNumber(field, parameter.quantity, step, numberOf(parameter), settingNumber(parameter));
        return field;
    }
    const SliderScale scale = usual.isLogarithmic ? SliderScale::Logarithmic : SliderScale::Linear;
    auto* slider =
        addRow(caption, new SliderField(fieldRange(parameter), usual.from * factor, usual.to * factor, scale), hint);
    bindNumber(slider, parameter.quantity, step, numberOf(parameter), settingNumber(parameter));
    return slider;
}

/// A box for by what it is told how many there are, and for each way a row, of which one is seen.
void LayerRows::addCount(const LayerParameter& parameter, const QString& step) {
    const QString caption = patternText(parameter.caption), hint = patternText(parameter.hint);
    auto* by = addRow(tr("%1 by").arg(caption), new QComboBox,
                      tr("A number, or as many as follow from the area: so that all sizes get pieces of one size"));
    by->addItem(tr("Number"), static_cast<Id>(CountBy::Number));
    by->addItem(tr("Seeds per m²"), static_cast<Id>(CountBy::Density));
    by->addItem(tr("Size of pieces"), static_cast<Id>(CountBy::PieceSize));
    m_form.bind(
        by, step, [&parameter](const PatternLayer& layer) { return static_cast<Id>(countOf(parameter, layer).by); },
        [this, &parameter](PatternLayer& layer, Id entered) {
            const auto wanted = static_cast<CountBy>(entered);
            parameter.write(layer.parameters, converted(countOf(parameter, layer), wanted, m_area));
        });
    const auto bound = [&](CountBy way, Quantity quantity, auto* control) {
        bindNumber(
            control, quantity, step,
            [this, &parameter, way](const PatternLayer& layer) {
                return converted(countOf(parameter, layer), way, m_area).amount;
            },
            [&parameter, way](PatternLayer& layer, double entered) {
                parameter.write(layer.parameters, SeedCount(way, entered));
            });
        m_showUsed.push_back([this, control, way, &parameter](const PatternLayer& layer) {
            setRowVisible(control, countOf(parameter, layer).by == way);
        });
    };
    const FieldRange whole = FieldRange::whole(parameter.range.min, parameter.range.max);
    const UsualRange& usual = parameter.usual;
    if (usual.from == usual.to) {
        auto* number = addRow(caption, new NumberField, hint);
        number->setRange(whole);
        bound(CountBy::Number, Quantity::Number, number);
    } else {
        bound(CountBy::Number, Quantity::Number,
              addRow(caption, new SliderField(whole, usual.from, usual.to, SliderScale::Logarithmic), hint));
    }
    bound(CountBy::Density, Quantity::Number,
          addRow(tr("Seeds per m²"), new SliderField(FieldRange::aboveZero(), 0.1, 10'000.0, SliderScale::Logarithmic),
                 tr("How many seeds a square metre of the outline gets")));
    bound(CountBy::PieceSize, Quantity::Length,
          addRow(tr("Size of pieces"), new SliderField(FieldRange::aboveZero(), 0.005, 2.0, SliderScale::Logarithmic),
                 tr("How long the sides of a square are that is as large as a piece on average")));
}

QWidget* LayerRows::addChoice(const LayerParameter& parameter, const QString& step) {
    auto* box = addRow(patternText(parameter.caption), new QComboBox, patternText(parameter.hint));
    for (std::size_t k = 0; k < parameter.choices.size(); ++k) {
        box->addItem(patternText(parameter.choices[k].caption), static_cast<Id>(k));
    }
    m_form.bind(
        box, step,
        [&parameter](const PatternLayer& layer) {
            return static_cast<Id>(std::get<double>(parameter.read(layer.parameters)));
        },
        [&parameter](PatternLayer& layer, Id entered) {
            parameter.write(layer.parameters, static_cast<double>(entered));
        });
    return box;
}

void LayerRows::addPoint(const LayerParameter& parameter, const QString& step) {
    const QStringList axes{tr("x"), tr("y")};
    for (int axis = 0; axis < 2; ++axis) {
        auto* field = addRow(tr("%1 %2").arg(patternText(parameter.caption), axes[axis]), new NumberField,
                             patternText(parameter.hint));
        m_form.bind(
            field, step,
            [&parameter, axis](const PatternLayer& layer) {
                return std::get<Vec2>(parameter.read(layer.parameters))[axis];
            },
            [&parameter, axis](PatternLayer& layer, double entered) {
                Vec2 point = std::get<Vec2>(parameter.read(layer.parameters));
                point[axis] = entered;
                parameter.write(layer.parameters, point);
            });
        m_takeUnits.push_back([field](const Units& units) { field->setFormat(units.lengths()); });
    }
}

void LayerRows::setUnits(const Units& units) {
    for (const auto& take : m_takeUnits) take(units);
}

void LayerRows::refresh(const PatternLayer& layer, double area) {
    m_area = area;
    for (const auto& show : m_showUsed) show(layer);
    m_form.refresh();
}

}  // namespace rubble
