#include "core/asset/finish/FinishParameters.h"

namespace rubble {
namespace {

struct Sides {
    FinishParameters outside, inside;
};

const glm::vec4 kMortar(0.40f, 0.385f, 0.35f, 0.0f);

/// Every second course is shifted by half a length.
CourseForm halfShifted(float length, float height) {
    return {.height = height, .even = {length, length}, .odd = {length, length}, .oddStart = 0.5f * length};
}

Sides brick() {
    return {.outside = {.broadScale = 0.9f,
                        .fineScale = 8.0f,
                        .broadTone = 0.12f,
                        .fineTone = 0.20f,
                        .courseTone = 0.24f,
                        .stain = {0.80f, 0.72f, 0.70f, 0.5f},
                        .speck = {0.55f, 0.50f, 0.48f, 0.5f},
                        .speckSize = 0.16f,
                        .speckHeight = -0.0012f,
                        .roughness = 0.88f,
                        .fineHeight = 0.0012f,
                        .courses = halfShifted(0.25f, 0.081f),
                        .jointWidth = 0.011f,
                        .jointHeight = -0.005f,
                        .joint = kMortar},
            .inside = {.broadScale = 3.0f,
                       .fineScale = 10.0f,
                       .broadTone = 0.16f,
                       .fineTone = 0.26f,
                       .speck = {0.42f, 0.38f, 0.36f, 0.75f},
                       .speckSize = 0.26f,
                       .speckSoftness = 0.08f,
                       .speckHeight = -0.004f,
                       .roughness = 0.95f,
                       .broadHeight = 0.008f,
                       .fineHeight = 0.003f}};
}

Sides concrete() {
    return {.outside = {.broadScale = 0.55f,
                        .fineScale = 6.0f,
                        .broadTone = 0.16f,
                        .fineTone = 0.09f,
                        .stain = {0.78f, 0.76f, 0.74f, 0.6f},
                        .speck = {0.45f, 0.45f, 0.45f, 0.7f},
                        .speckSize = 0.11f,
                        .speckSoftness = 0.03f,
                        .speckHeight = -0.002f,
                        .roughness = 0.82f,
                        .fineHeight = 0.0009f,
                        .roughnessTone = 0.1f},
            .inside = {.broadScale = 2.0f,
                       .fineScale = 4.5f,
                       .broadTone = 0.16f,
                       .fineTone = 0.16f,
                       .speck = {1.30f, 1.20f, 1.06f, 0.85f},
                       .speckSize = 0.40f,
                       .speckSoftness = 0.05f,
                       .speckHeight = 0.006f,
                       .roughness = 0.95f,
                       .broadHeight = 0.012f,
                       .fineHeight = 0.004f}};
}

Sides glass() {
    return {.outside = {.roughness = 0.04f},
            .inside = {.broadScale = 1.5f,
                       .warp = 0.03f,
                       .roughness = 0.12f,
                       .bandHeight = 0.0008f,
                       .bandCentre = {0.35f, 0.28f, -0.2f, 36.0f},
                       .bandAxes = {1.0f, 1.0f, 1.0f, 0.0f}}};
}

Sides ice() {
    return {.outside = {.broadScale = 1.2f,
                        .fineScale = 4.0f,
                        .broadTone = 0.06f,
                        .stain = {1.25f, 1.22f, 1.18f, 0.6f},
                        .roughness = 0.16f,
                        .broadHeight = 0.006f,
                        .fineHeight = 0.0008f,
                        .roughnessTone = 0.08f},
            .inside = {.broadScale = 1.6f,
                       .fineScale = 6.0f,
                       .warp = 0.06f,
                       .broadTone = 0.08f,
                       .speck = {1.6f, 1.55f, 1.5f, 0.5f},
                       .speckSize = 0.2f,
                       .speckSoftness = 0.1f,
                       .roughness = 0.3f,
                       .broadHeight = 0.008f,
                       .fineHeight = 0.001f,
                       .bandHeight = 0.0015f,
                       .roughnessTone = 0.15f,
                       .bandCentre = {0.3f, 0.5f, -0.3f, 22.0f},
                       .bandAxes = {1.0f, 1.0f, 1.0f, 0.0f}}};
}

Sides metal() {
    return {.outside = {.broadScale = 0.7f,
                        .fineScale = 9.0f,
                        .stretch = 14.0f,
                        .broadTone = 0.05f,
                        .fineTone = 0.10f,
                        .roughness = 0.34f,
                        .fineHeight = 0.0002f,
                        .roughnessTone = 0.12f,
                        .bandAxes = {0.0f, 0.0f, 0.0f, 1.0f}},
            .inside = {.broadScale = 3.0f,
                       .fineScale = 12.0f,
                       .broadTone = 0.10f,
                       .fineTone = 0.25f,
                       .roughness = 0.55f,
                       .broadHeight = 0.004f,
                       .fineHeight = 0.002f,
                       .roughnessTone = 0.15f,
                       .bandAxes = {0.0f, 0.0f, 0.0f, 1.0f}}};
}

Sides plaster() {
    return {.outside = {.broadScale = 0.8f,
                        .fineScale = 9.0f,
                        .broadTone = 0.06f,
                        .fineTone = 0.05f,
                        .stain = {0.9f, 0.88f, 0.85f, 0.4f},
                        .roughness = 0.9f,
                        .broadHeight = 0.002f,
                        .fineHeight = 0.0009f},
            .inside = {.broadScale = 3.0f,
                       .fineScale = 12.0f,
                       .broadTone = 0.08f,
                       .fineTone = 0.14f,
                       .speck = {0.7f, 0.7f, 0.7f, 0.5f},
                       .speckSize = 0.16f,
                       .speckHeight = -0.002f,
                       .roughness = 0.97f,
                       .broadHeight = 0.006f,
                       .fineHeight = 0.003f}};
}

Sides stone() {
    return {.outside = {.broadScale = 0.8f,
                        .fineScale = 4.0f,
                        .warp = 0.35f,
                        .broadTone = 0.20f,
                        .fineTone = 0.22f,
                        .bandTone = 0.16f,
                        .stain = {0.72f, 0.75f, 0.66f, 0.6f},
                        .roughness = 0.86f,
                        .broadHeight = 0.02f,
                        .fineHeight = 0.005f,
                        .roughnessTone = 0.08f,
                        .bandCentre = {0.0f, -40.0f, 0.0f, 5.0f},
                        .bandAxes = {0.0f, 1.0f, 0.0f, 0.0f}},
            .inside = {.broadScale = 1.6f,
                       .fineScale = 7.0f,
                       .warp = 0.35f,
                       .broadTone = 0.16f,
                       .fineTone = 0.30f,
                       .bandTone = 0.12f,
                       .speck = {1.7f, 1.65f, 1.6f, 0.45f},
                       .speckSize = 0.22f,
                       .roughness = 0.78f,
                       .broadHeight = 0.014f,
                       .fineHeight = 0.004f,
                       .roughnessTone = 0.15f,
                       .bandCentre = {0.0f, -40.0f, 0.0f, 5.0f},
                       .bandAxes = {0.0f, 1.0f, 0.0f, 0.0f}}};
}

Sides tiles() {
    const Sides clay = brick();
    return {.outside = {.broadScale = 0.9f,
                        .fineScale = 8.0f,
                        .broadTone = 0.10f,
                        .fineTone = 0.12f,
                        .courseTone = 0.20f,
                        .stain = {0.62f, 0.62f, 0.58f, 0.5f},
                        .roughness = 0.62f,
                        .fineHeight = 0.0006f,
                        .roughnessTone = 0.12f,
                        .courses = halfShifted(0.20f, 0.28f),
                        .jointWidth = 0.008f,
                        .jointHeight = -0.010f,
                        .joint = {0.05f, 0.04f, 0.035f, 0.0f},
                        .lap = 0.016f,
                        .lapShade = 0.03f},
            .inside = clay.inside};
}

Sides wood() {
    const FinishParameters outside{.broadScale = 0.8f,
                                   .fineScale = 6.0f,
                                   .stretch = 12.0f,
                                   .warp = 0.05f,
                                   .broadTone = 0.12f,
                                   .fineTone = 0.16f,
                                   .bandTone = 0.55f,
                                   .roughness = 0.55f,
                                   .fineHeight = 0.0004f,
                                   .bandHeight = 0.0006f,
                                   .roughnessTone = 0.1f,
                                   .bandCentre = {0.0f, -0.37f, 0.13f, 55.0f},
                                   .bandAxes = {0.0f, 1.0f, 1.0f, 0.0f}};
    Sides sides{outside, outside};
    sides.inside.fineScale = 9.0f;
    sides.inside.fineTone = 0.34f;
    sides.inside.fineHeight = 0.005f;
    sides.inside.broadHeight = 0.006f;
    sides.inside.roughness = 0.9f;
    return sides;
}

}  // namespace

const FinishParameters& finishParameters(Finish finish, FinishSide side) {
    static const std::array<Sides, kFinishNames.size()> kFinishes{Sides{}, brick(),   concrete(), glass(), ice(),
                                                                  metal(), plaster(), stone(),    tiles(), wood()};
    const Sides& sides = kFinishes[static_cast<std::size_t>(finish)];
    return side == FinishSide::Outside ? sides.outside : sides.inside;
}

FinishParameters withCourses(FinishParameters parameters, const BrickCourseFrame& courses) {
    if (!courses.isOn || parameters.jointWidth == 0.0f) return parameters;
    parameters.courses = courses.form;
    parameters.jointWidth = courses.jointWidth;
    if (courses.jointWidth == 0.0f) parameters.jointHeight = 0.0f;
    return parameters;
}

std::array<glm::vec4, 12> packedFinish(const FinishParameters& parameters) {
    const FinishParameters& p = parameters;
    return {glm::vec4(p.broadScale, p.fineScale, 1.0f / p.stretch, p.warp),
            {p.broadTone, p.fineTone, p.bandTone, p.courseTone},
            p.stain,
            p.speck,
            {p.speckSize, p.speckSoftness, p.speckHeight, p.roughness},
            {p.broadHeight, p.fineHeight, p.bandHeight, p.roughnessTone},
            p.bandCentre,
            p.bandAxes,
            {p.courses.even[0], p.courses.height, p.jointWidth, p.jointHeight},
            p.joint,
            {p.lap, p.lapShade, 0.0f, 0.0f},
            {p.courses.even[1], p.courses.odd[0], p.courses.odd[1], p.courses.oddStart}};
}

}  // namespace rubble
