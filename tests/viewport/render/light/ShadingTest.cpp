// Tests viewport/render/light/ReflectionTexture.cpp and the shaders that it is for: frame.glsl, sky_light.glsl,
// background.glsl and material.glsl.
#include "viewport/render/light/ReflectionTexture.h"

#include "tests/support/TestProgram.h"
#include "viewport/render/FrameBlock.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/gl/ShaderProgram.h"
#include "viewport/render/gl/SurfacelessContext.h"
#include "viewport/render/light/ToneMapping.h"

#include <epoxy/gl.h>
#include <QFile>
#include <QTest>
#include <glm/geometric.hpp>

#include <cmath>
#include <functional>

using namespace rubble;

namespace {

constexpr int kTableWidth = 64;

std::string shaderText(const char* name) {
    QFile file(QString(RUBBLE_SOURCE_DIR "/resources/shaders/") + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

GLuint compiledShader(GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

/// The values of a GLSL expression for `place` in [0, 1]², row by row.
std::vector<glm::vec4> evaluated(const FrameBlock& frame, const std::string& expression) {
    const std::string version = "#version 330 core\n" + shaderText("frame.glsl");
    const std::string fragment = version + shaderText("sky_light.glsl") + shaderText("background.glsl") +
                                 shaderText("material.glsl") +
                                 "in vec2 place;\nout vec4 pixel;\nvoid main() { pixel = " + expression + "; }\n";
    const GlProgram program = GlProgram::create();
    glAttachShader(program.id(), compiledShader(GL_VERTEX_SHADER, version + shaderText("fullscreen.vert")));
    glAttachShader(program.id(), compiledShader(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program.id());
    glUseProgram(program.id());
    glUniform1i(glGetUniformLocation(program.id(), "reflections"), static_cast<GLint>(TextureUnit::Reflections));
    const GlBuffer uniforms = GlBuffer::create();
    glBindBuffer(GL_UNIFORM_BUFFER, uniforms.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms.id());
    const RenderTarget target({kTableWidth, kTableWidth}, PixelFormat::Float, 1);
    target.bind();
    const GlVertexArray array = GlVertexArray::create();
    glBindVertexArray(array.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> values(std::size_t{kTableWidth} * kTableWidth, glm::vec4(NAN));
    glReadPixels(0, 0, kTableWidth, kTableWidth, GL_RGBA, GL_FLOAT, values.data());
    return values;
}

/// Calls `check` with the place and the value of each pixel.
template <class Check>
void forEachPlace(const std::vector<glm::vec4>& values, Check check) {
    for (int y = 0; y < kTableWidth; ++y) {
        for (int x = 0; x < kTableWidth; ++x)
            check(Vec2(x + 0.5, y + 0.5) / static_cast<double>(kTableWidth),
                  Vec3(values[static_cast<std::size_t>(y * kTableWidth + x)]));
    }
}

/// The largest distance of the values from the expected ones, as a part of 1 + their length.
double largestError(const std::vector<glm::vec4>& values, const std::function<Vec3(Vec2)>& expected) {
    double largest = 0.0;
    forEachPlace(values, [&](Vec2 place, Vec3 value) {
        const Vec3 wanted = expected(place);
        const double error = glm::length(value - wanted) / (1.0 + glm::length(wanted));
        largest = error <= largest ? largest : error;  // also if it is no number
    });
    return largest;
}

/// A frame in the light of a sky without its sun.
FrameBlock frameIn(const SkyLight& light, const RenderSettings& settings = {}) {
    RenderView view{.size = {kTableWidth, kTableWidth}, .settings = settings};
    FrameBlock frame = frameBlock(view, {}, {}, light, singleSample(light.sky));
    frame.keyLight = glm::vec4(0.0f);
    return frame;
}

/// What GGX facets with Smith's shadowing reflect once of light from everywhere: with a reflectance of 1, and of 0, at
/// normal incidence; by integration over their normals.
Vec2 facetReflectance(double roughness, double facingEye) {
    constexpr int kSteps = 32;
    const double square = std::pow(roughness, 4.0), aside = std::sqrt(1.0 - facingEye * facingEye);
    Vec2 sum(0.0);
    for (int k = 0; k < kSteps; ++k) {
        for (int j = 0; j < kSteps; ++j) {
            const double part = (k + 0.5) / kSteps, azimuth = 2.0 * M_PI * (j + 0.5) / kSteps;
            const double up = std::sqrt((1.0 - part) / (1.0 + (square - 1.0) * part));
            const double facing = aside * std::sqrt(1.0 - up * up) * std::cos(azimuth) + facingEye * up;
            const double light = 2.0 * facing * up - facingEye;
            if (light <= 0.0 || facing <= 0.0) continue;
            const double lambdas = light * std::sqrt(facingEye * facingEye * (1.0 - square) + square) +
                                   facingEye * std::sqrt(light * light * (1.0 - square) + square);
            const double weight = 2.0 / lambdas * light * facing / up;
            sum += weight * Vec2(1.0, std::pow(1.0 - facing, 5.0));
        }
    }
    return sum / static_cast<double>(kSteps * kSteps);
}

/// One that has the same radiance from everywhere.
SkyLight uniformLight() {
    Sky sky{.zenith = Vec3(1.0), .horizon = Vec3(1.0), .groundAlbedo = Vec3(2.0)};
    return skyLightOf(sky);
}

/// Of all places: the normal is (0, 1, 0) tilted over all azimuths and heights.
const std::string kDirection =
    "vec3(sqrt(1.0 - (2.0 * place.y - 1.0) * (2.0 * place.y - 1.0)) * cos(6.2831853 * place.x), 2.0 * place.y - 1.0, "
    "sqrt(1.0 - (2.0 * place.y - 1.0) * (2.0 * place.y - 1.0)) * sin(6.2831853 * place.x))";
Vec3 directionAt(Vec2 place) {
    const double height = 2.0 * place.y - 1.0, aside = std::sqrt(1.0 - height * height);
    return {aside * std::cos(2.0 * M_PI * place.x), height, aside * std::sin(2.0 * M_PI * place.x)};
}

}  // namespace

class ShadingTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { m_context = SurfacelessContext::create().value(); }
    void cleanupTestCase() { m_context.reset(); }

    /// Differences of half a step of 8 bits cannot be seen.
    void transferFitsTheStandard() {
        const FrameBlock frame = frameIn(uniformLight());
        double worst = 0.0;
        forEachPlace(evaluated(frame, "vec4(srgbOf(vec3(place.x + place.y * place.y / 64.0)), 1.0)"),
                     [&](Vec2 place, Vec3 value) {
                         const double linear = std::min(place.x + place.y * place.y / 64.0, 1.0);
                         worst = std::max(worst, std::abs(value.x - srgbOf(linear)));
                     });
        QVERIFY2(worst < 0.4 / 255.0, qPrintable(QString::number(255.0 * worst)));
        worst = 0.0;
        forEachPlace(evaluated(frame, "vec4(linearOf(vec3(place.x + (place.y - 0.5) / 64.0)), 1.0)"),
                     [&](Vec2 place, Vec3 value) {
                         const double srgb = place.x + (place.y - 0.5) / 64.0;
                         worst = std::max(worst, std::abs(srgbOf(value.x) - srgb));
                     });
        QVERIFY2(worst < 0.4 / 255.0, qPrintable(QString::number(255.0 * worst)));
    }
    void toneCurveIsThatOfTheProcessor() {
        const auto values =
            evaluated(frameIn(uniformLight()), "vec4(toneMapped(vec3(2.0 * place.x, place.y, 0.3)), 1.0)");
        const double error = largestError(values, [](Vec2 place) { return toneMapped({2.0 * place.x, place.y, 0.3}); });
        QVERIFY2(error < 1e-4, qPrintable(QString::number(error)));
    }
    void exposureDoublesTheLight() {
        const FrameBlock frame = frameIn(uniformLight(), {.exposure = 1.0});
        const double error = largestError(evaluated(frame, "vec4(displayed(vec3(0.5 * place.x)), 1.0)"),
                                          [](Vec2 place) { return srgbOf(toneMapped(Vec3(place.x))); });
        QVERIFY2(error < 0.002, qPrintable(QString::number(error)));
    }
    void lightOfTheSkyIsThatOfTheProcessor_data() {
        QTest::addColumn<int>("preset");
        QTest::newRow("studio") << static_cast<int>(SkyPreset::Studio);
        QTest::newRow("evening") << static_cast<int>(SkyPreset::Evening);
        QTest::newRow("night") << static_cast<int>(SkyPreset::Night);
    }
    void lightOfTheSkyIsThatOfTheProcessor() {
        QFETCH(int, preset);
        const auto sky = static_cast<SkyPreset>(preset);
        const SkyLight light = skyLightOf(skyOf(sky, Theme::Light));
        const FrameBlock frame = frameIn(light, {.sky = sky});
        ReflectionTexture texture;
        texture.upload(light.reflections);
        const double diffuse =
            largestError(evaluated(frame, "vec4(diffuseSky(" + kDirection + "), 1.0)"),
                         [&](Vec2 place) { return glm::max(valueFor(light.diffuse, directionAt(place)), 0.0); });
        QVERIFY2(diffuse < 1e-4, qPrintable(QString::number(diffuse)));
        const double mirrored =
            largestError(evaluated(frame, "vec4(reflected(" + kDirection + ", 0.3), 1.0)"),
                         [&](Vec2 place) { return reflected(light.reflections, directionAt(place), 0.3); });
        // Texels are half floats, and their weights have steps of 1/256.
        QVERIFY2(mirrored < 0.01, qPrintable(QString::number(mirrored)));
        if (sky == SkyPreset::Studio) return;  // its backdrop is another
        const double background =
            largestError(evaluated(frame, "vec4(skyRadiance(" + kDirection + "), 1.0)"),
                         [&](Vec2 place) { return backgroundRadiance(light.sky, directionAt(place)); });
        QVERIFY2(background < 1e-3, qPrintable(QString::number(background)));
    }
    /// In light that is the same from everywhere, a white body is invisible: it takes none and adds none.
    void whiteFurnace_data() {
        QTest::addColumn<double>("metalness");
        QTest::newRow("dielectric") << 0.0;
        QTest::newRow("metal") << 1.0;
        QTest::newRow("between") << 0.5;
    }
    void whiteFurnace() {
        QFETCH(double, metalness);
        const SkyLight light = uniformLight();
        QVERIFY(glm::length(light.ground - Vec3(1.0)) < 0.005);
        ReflectionTexture texture;
        texture.upload(light.reflections);
        double worst = 0.0;  // for all roughnesses and angles
        const std::string surface =
            "Surface(vec3(1.0), normalize(vec3(0.3, 0.8, 0.5)), place.x, " + std::to_string(metalness) + ", 1.0)";
        const std::string toEye =
            "normalize(place.y * normalize(vec3(0.3, 0.8, 0.5)) + sqrt(1.0 - place.y * place.y) "
            "* normalize(vec3(0.8, -0.3, 0.0)))";
        forEachPlace(
            evaluated(frameIn(light), "vec4(lit(" + surface + ", " + toEye + ", vec2(1.0)), 1.0)"),
            [&](Vec2, Vec3 value) { worst = std::max(worst, glm::length(value - Vec3(1.0)) / std::sqrt(3.0)); });
        QVERIFY2(worst < 0.02, qPrintable(QString::number(worst)));
    }
    void reflectanceIsThatOfFacets() {
        double sum = 0.0, worst = 0.0;
        forEachPlace(evaluated(frameIn(uniformLight()), "vec4(environmentReflectance(place.x, place.y), 0.0, 1.0)"),
                     [&](Vec2 place, Vec3 value) {
                         const Vec2 expected = facetReflectance(std::max(place.x, 0.04), place.y);
                         const double apart = std::max(std::abs(value.x - expected.x), std::abs(value.y - expected.y));
                         sum += apart;
                         worst = std::max(worst, apart);
                     });
        const double mean = sum / (kTableWidth * kTableWidth);
        QVERIFY2(mean < 0.025 && worst < 0.15, qPrintable(QString("%1, %2").arg(mean).arg(worst)));
    }
    /// The lobe of the key light, with its diffuse part, reflects no more than arrives.
    void keyLightGivesNoEnergy() {
        const SkyLight light = uniformLight();
        FrameBlock frame = frameIn(light);
        frame.groundLight = {0.0f, 0.0f, 0.0f, 1.0f};
        for (glm::vec4& part : frame.skyLight) part = glm::vec4(0.0f);
        frame.keyLight = glm::vec4(1.0f, 1.0f, 1.0f, 0.0f);
        frame.keyDirection = {glm::vec3(glm::normalize(Vec3(0.5, 0.7, 0.0))), 0.0f};
        ReflectionTexture texture;
        texture.upload(reflectionMap([](Vec3) { return Vec3(0.0); }));
        for (const double metalness : {0.0, 1.0}) {
            for (const double roughness : {0.3, 0.5, 0.8, 1.0}) {
                // Towards all eyes of the upper hemisphere, evenly.
                const std::string toEye =
                    "vec3(sqrt(1.0 - place.y * place.y) * cos(6.2831853 * place.x), place.y, "
                    "sqrt(1.0 - place.y * place.y) * sin(6.2831853 * place.x))";
                const std::string surface = "Surface(vec3(1.0), vec3(0.0, 1.0, 0.0), " + std::to_string(roughness) +
                                            ", " + std::to_string(metalness) + ", 1.0)";
                double sum = 0.0;
                forEachPlace(evaluated(frame, "vec4(lit(" + surface + ", " + toEye + ", vec2(1.0)), 1.0)"),
                             [&](Vec2 place, Vec3 value) { sum += 2.0 * place.y * value.x; });
                const double part = sum / (kTableWidth * kTableWidth) / static_cast<double>(frame.keyDirection.y);
                QVERIFY2(part > 0.85 && part < 1.06, qPrintable(QString("%1 at %2").arg(part).arg(roughness)));
            }
        }
    }

private:
    std::unique_ptr<SurfacelessContext> m_context;
};

RUBBLE_TEST_WITH(ShadingTest, QCoreApplication)
#include "ShadingTest.moc"
