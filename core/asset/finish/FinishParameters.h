#pragma once

#include "core/asset/project/Finish.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace rubble {

/// Courses of bricks of equal height, each with two alternating lengths; every second course is another.
struct CourseForm {
    float height = 1.0f;                       // m, with a joint, as all lengths
    std::array<float, 2> even = {1.0f, 1.0f};  // m
    std::array<float, 2> odd = {1.0f, 1.0f};   // m
    float oddStart = 0.0f;                     // m: of the first brick of odd courses, from that of even ones
    bool operator==(const CourseForm&) const = default;
};

/// A finish of one side as the parameters of one formula, which finish.glsl and finishedSurface() evaluate: two
/// samples of FinishNoise, one of broad and one of fine features, change the brightness of the material's colour and
/// its height; specks (cells of the fine sample), bands and courses are added. Lengths in metres, in the asset's frame
/// with the grain along x; brightness and colours are factors of the material's colour, which is linear.
struct FinishParameters {
    float broadScale = 1.0f;  // repetitions of the noise a metre, as the next
    float fineScale = 6.0f;
    float stretch = 1.0f;  // of the noise along the grain
    float warp = 0.0f;     // m, by which broad noise bends the bands
    float broadTone = 0.0f, fineTone = 0.0f, bandTone = 0.0f, courseTone = 0.0f;  // amplitudes of brightness
    glm::vec4 stain{1.0f, 1.0f, 1.0f, 0.0f};  // colour, and how much where broad noise is high
    glm::vec4 speck{1.0f, 1.0f, 1.0f, 0.0f};  // the same, in specks
    float speckSize = 0.0f;                   // radius, of the width of a cell of the fine noise
    float speckSoftness = 0.05f;
    float speckHeight = 0.0f;  // m
    float roughness = 0.8f;
    float broadHeight = 0.0f, fineHeight = 0.0f, bandHeight = 0.0f;  // m
    float roughnessTone = 0.0f;                                      // amplitude
    glm::vec4 bandCentre{0.0f};                                      // of bands: m; w: how many a metre
    glm::vec4 bandAxes{0.0f};  // 1: bands are at distances along these axes; w: metalness of the surface
    CourseForm courses;
    float jointWidth = 0.0f, jointHeight = 0.0f;  // m; without joints: 0
    glm::vec4 joint{0.0f};                        // linear colour
    float lap = 0.0f;       // m: how far the lower edge of a course stands out above the course below, as of tiles
    float lapShade = 0.0f;  // m: as far down from that edge the course below is in its shade
};

enum class FinishSide { Outside, Inside };
const FinishParameters& finishParameters(Finish finish, FinishSide side);

/// The courses of bricks that fragments are cut along, in place of those of a finish, so that each brick has its tone.
struct BrickCourseFrame {
    bool isOn = false;
    glm::vec2 origin{0.0f};  // m: the lower left corner of course 0
    CourseForm form;
    float jointWidth = 0.0f;  // m; 0: joints are geometry
    bool operator==(const BrickCourseFrame&) const = default;
};
FinishParameters withCourses(FinishParameters parameters, const BrickCourseFrame& courses);

/// The parameters in the order of finish.glsl.
std::array<glm::vec4, 12> packedFinish(const FinishParameters& parameters);

}  // namespace rubble
