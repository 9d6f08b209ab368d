// Tests core/io/project/MaterialPresetFile.cpp and core/asset/library/MaterialPreset.cpp.
#include "core/io/project/MaterialPresetFile.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/library/StarterProject.h"
#include "core/base/MessageText.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonMutations.h"
#include "tests/support/files/Schemas.h"
#include "tests/support/files/WrongValues.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

const fs::path kPresets = RUBBLE_SOURCE_DIR "/resources/materials";

nlohmann::json glassJson() { return nlohmann::json::parse(*readFile(kPresets / "glass.json")); }

/// A preset with the required keys only.
nlohmann::json barestJson() {
    nlohmann::json json = glassJson();
    for (const char* key : {"note", "tensileStrength", "fractureToughness", "youngsModulus", "opacity", "finish",
                            "pattern", "cutAtImpact"})
        json.erase(key);
    for (const char* key : {"density", "friction", "restitution"}) json[key] = {{"value", json[key]["value"]}};
    return json;
}

std::string presetFault(std::string_view text) { return errorText(readMaterialPresetText(text)); }

bool noneFits(const std::string&, const nlohmann::json&) { return false; }

/// The plausible range of a property of breakable solids.
struct Sane {
    const char* name;
    double low;
    double high;
};

/// Returns the error in a property's source: it must be a work with its year or be called typical, and state both ends
/// of the range (in the unit of the file, kilo, mega or giga).
std::string sourceFault(const PresetFigure& figure) {
    static const QRegularExpression year("\\b(1[67]|19|20)\\d\\d\\b");
    static const QRegularExpression number("\\d+(\\.\\d+)?");
    const QString source = QString::fromStdString(figure.source);
    if (!source.startsWith("Typical") && !source.contains(year)) return "no year";
    if (!figure.range) return "";
    for (const double end : {figure.range->first, figure.range->second}) {
        bool isReported = false;
        for (auto match = number.globalMatch(source); match.hasNext() && !isReported;) {
            const double reported = match.next().captured().toDouble();
            for (const double unit : {1.0, 1e3, 1e6, 1e9}) isReported |= qFuzzyCompare(reported * unit, end);
        }
        if (!isReported) return "not reported: " + messageText(end);
    }
    return "";
}

void verifyFigure(const PresetFigure& figure, const Sane& sane) {
    QVERIFY2(figure.value >= sane.low && figure.value <= sane.high, sane.name);
    QCOMPARE(sane.name + (": " + sourceFault(figure)), std::string(sane.name) + ": ");
}

}  // namespace

class MaterialPresetFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    fs::path folder() const { return m_folder.path().toStdString(); }
    void write(const char* name, const nlohmann::json& json) const {
        QVERIFY(writeFileAtomically(folder() / name, json.dump()));
    }

private slots:
    void init() {
        for (const auto& entry : fs::directory_iterator(folder())) fs::remove_all(entry);
    }

    void thereAreEightBuiltInMaterials() {
        const MaterialLibrary library = materialLibrary();
        QCOMPARE(library.errors.size(), std::size_t{0});
        std::string names;
        for (const LibraryMaterial& material : library.materials) names += material.preset.name + " ";
        QCOMPARE(names, std::string("brick concrete glass ice metal plaster stone wood "));
    }
    void presetsHaveSourcesAndPlausibleValues() {
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const MaterialPreset& preset = material.preset;
            QVERIFY2(material.file.empty() && !preset.note.empty(), preset.name.c_str());
            verifyFigure(preset.density, {"density", 400.0, 8000.0});
            verifyFigure(preset.friction, {"friction", 0.05, 1.0});
            verifyFigure(preset.restitution, {"restitution", 0.1, 0.7});
            QVERIFY(preset.tensileStrength && preset.fractureToughness && preset.youngsModulus);
            verifyFigure(*preset.tensileStrength, {"tensile strength", 1e5, 1e9});
            verifyFigure(*preset.fractureToughness, {"fracture toughness", 5e4, 1e8});
            verifyFigure(*preset.youngsModulus, {"Young's modulus", 1e9, 3e11});
            QVERIFY2(!preset.pattern.layers.empty(), preset.name.c_str());
        }
    }
    void presetFilesAreInCanonicalForm() {
        const test::Schema schema("material.schema.json");
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const Result<std::string> text = readFile(kPresets / (material.preset.name + ".json"));
            QVERIFY2(text, material.preset.name.c_str());
            QCOMPARE(materialPresetText(material.preset), *text);
            QCOMPARE(schema.fault(nlohmann::json::parse(*text)), std::string());
        }
    }
    void glassAndIceAreTransparent() {
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const bool isClear = material.preset.name == "glass" || material.preset.name == "ice";
            QCOMPARE(material.preset.opacity < 1.0, isClear);
            QCOMPARE(materialOf(material.preset, 1).opacity, material.preset.opacity);
            QCOMPARE(presetOf(materialOf(material.preset, 1), nullptr).opacity, material.preset.opacity);
        }
    }
    void manualStatesTheSameValues() {
        const Result<std::string> manual = readFile(RUBBLE_SOURCE_DIR "/docs/manual/materials.md");
        QVERIFY(manual);
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const MaterialPreset& preset = material.preset;
            std::string row = "| " + preset.name;
            for (const double figure : {preset.density.value, preset.friction.value, preset.restitution.value,
                                        preset.tensileStrength->value / 1e6, preset.fractureToughness->value / 1e6,
                                        preset.youngsModulus->value / 1e9}) {
                row += " | " + roundedText(figure, 6);
            }
            row += " | " + preset.note + " |\n";
            QVERIFY2(manual->find(row) != std::string::npos, row.c_str());
        }
    }
    void defaultPatternsBakeOnEveryOutline_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("outline");
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const QString name = QString::fromStdString(material.preset.name);
            for (int k = 0; k < 3; ++k) QTest::addRow("%s %d", qPrintable(name), k) << name << k;
        }
    }
    void defaultPatternsBakeOnEveryOutline() {
        QFETCH(QString, name);
        QFETCH(int, outline);
        const std::array<Polygon, 3> outlines{unitSquare(), lShape(), squareRing()};
        const MaterialLibrary library = materialLibrary();
        const MaterialPreset& preset = findMaterial(library, name.toStdString())->preset;
        Asset asset{.id = 100, .name = "wall", .material = 1};
        asset.shape = Prism{outlines[static_cast<std::size_t>(outline)], 0.2};
        asset.pattern = patternWithin(preset, boundsOf(asset.prism().outline.outer));
        const Result<Bake> baked = bake(asset);
        QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
        QCOMPARE(verifyBake(*baked, asset).value_or(""), std::string());
        const Partition& partition = baked->fractureOf(kNone)->fragments.extruded()->partition;
        QCOMPARE(verifyPartition(partition, validated(asset.prism())->outline).value_or(""), std::string());
        QVERIFY2(baked->fragmentCount() >= 5 && baked->fragmentCount() <= 800,
                 qPrintable(QString::number(baked->fragmentCount())));
    }
    void patternsScaleWithTheOutline() {
        const MaterialLibrary library = materialLibrary();
        for (const char* name : {"concrete", "wood", "plaster", "stone", "metal"}) {
            std::array<std::size_t, 2> counts{};
            for (std::size_t k = 0; k < 2; ++k) {
                const double side = k == 0 ? 2.0 : 4.0;
                const Polygon outline{rectangle({0.0, 0.0}, {side, side}), {}};
                const Pattern pattern = patternWithin(findMaterial(library, name)->preset, boundsOf(outline.outer));
                counts[k] = seedsOf(pattern, outline)->positions.size();
            }
            const double growth = static_cast<double>(counts[1]) / static_cast<double>(counts[0]);
            QVERIFY2(growth > 3.0 && growth < 5.0, name);  // four times the area
        }
    }
    void centresAreInTheMiddleOfTheOutline() {
        const MaterialLibrary library = materialLibrary();
        const Pattern glass = patternWithin(findMaterial(library, "glass")->preset, {{10.0, 20.0}, {14.0, 26.0}});
        QVERIFY((std::get<RadialCracks>(glass.layers[0].parameters).centre == Vec2{12.0, 23.0}));
        QCOMPARE(std::get<RadialCracks>(glass.layers[0].parameters).radius, 0.4);
        const Pattern brick = patternWithin(findMaterial(library, "Brick")->preset, {{10.0, 20.0}, {14.0, 26.0}});
        QVERIFY((std::get<BrickBond>(brick.layers[0].parameters).origin == Vec2{10.0, 20.0}));
    }
    void projectContainsACopy() {
        const MaterialLibrary library = materialLibrary();
        const Material copy = materialOf(findMaterial(library, "ice")->preset, 7);
        QCOMPARE(copy.id, Id{7});
        QCOMPARE(copy.density, 917.0);
        QCOMPARE(*copy.tensileStrength, 1.43e6);
        QCOMPARE(*copy.fractureToughness, 1e5);
    }
    void brittleMaterialsCrackWhereTheyAreHit() {
        std::vector<std::string> cut;
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const MaterialPreset& preset = material.preset;
            if (preset.cutAtImpact) cut.push_back(preset.name);
            QVERIFY(starterProject(preset).assets[0].cutAtImpact == preset.cutAtImpact);
        }
        QVERIFY((cut == std::vector<std::string>{"glass", "ice", "plaster"}));
        MaterialPreset bad = findMaterial(materialLibrary(), "glass")->preset;
        bad.cutAtImpact->fragments = 1;
        QVERIFY(verifyPreset(bad).value_or("").starts_with(
            "Material \"glass\": the number of fragments of the fracture at the impact is 1"));
    }
    void newProjectsHaveThePlasterOfTheLibrary() {
        const Material plaster = emptyProject().materials[0];
        QVERIFY(plaster == materialOf(findMaterial(materialLibrary(), "plaster")->preset, plaster.id));
    }
    void savedMaterialsRoundTrip() {
        Project project = starterProject();
        project.assets[0].shaping.roughness = {.amplitude = 0.01, .frequency = 7.0, .octaves = 2, .randomSeed = 5};
        project.assets[0].cutAtImpact = CutAtImpact{.fragments = 12, .falloffRadius = 0.2};
        const MaterialPreset preset = presetOf(project.materials[0], &project.assets[0]);
        QVERIFY(preset.cutAtImpact == project.assets[0].cutAtImpact);
        QVERIFY(preset.roughness == project.assets[0].shaping.roughness);
        const fs::path file = materialPresetPath(folder(), preset.name);
        QVERIFY(saveMaterialPreset(file, preset));
        QVERIFY(*loadMaterialPreset(file) == preset);
        QCOMPARE(preset.pattern.layers[0].id, Id{1});
        QCOMPARE(preset.tensileStrength->value, 1e6);
        const Material again = materialOf(preset, project.materials[0].id);
        QVERIFY(again == project.materials[0]);
    }
    void filesAreNamedAfterTheirMaterials() {
        const auto nameOf = [](const char* material) { return materialPresetPath("", material).string(); };
        QCOMPARE(nameOf("Dark oak"), std::string("dark-oak.json"));
        QCOMPARE(nameOf("../../etc/x: y"), std::string("etc-x-y.json"));
        QCOMPARE(nameOf("Gl\xc3\xa4ss"), std::string("gl\xc3\xa4ss.json"));
        QCOMPARE(nameOf("?"), std::string("material.json"));
    }
    void userPresetsAddAndReplace() {
        nlohmann::json own = glassJson();
        own["density"] = {{"value", 2480}};
        write("b.json", own);
        own["name"] = "lead glass";
        own.erase("pattern");
        own.erase("note");
        own.erase("fractureToughness");
        write("a.json", own);
        write("notes.txt", "this is not looked at");
        const MaterialLibrary library = materialLibrary(folder());
        QCOMPARE(library.errors.size(), std::size_t{0});
        QCOMPARE(library.materials.size(), std::size_t{9});
        QCOMPARE(findMaterial(library, "glass")->preset.density.value, 2480.0);
        QCOMPARE(findMaterial(library, "glass")->file, folder() / "b.json");
        QVERIFY(!findMaterial(library, "lead glass")->preset.fractureToughness);
        QVERIFY(materialLibrary(folder() / "none").materials.size() == 8);
    }
    void invalidFilesAreReportedAndTheRestLoads() {
        nlohmann::json own = glassJson();
        own["name"] = "lead glass";
        write("a.json", own);
        write("b.json", own);
        own["name"] = "broken glass";
        own["density"]["value"] = "heavy";
        write("c.json", own);
        QVERIFY(writeFileAtomically(folder() / "d.json", "{"));
        const MaterialLibrary library = materialLibrary(folder());
        QCOMPARE(library.materials.size(), std::size_t{9});
        QCOMPARE(library.errors.size(), std::size_t{3});
        const std::string in = folder().string();
        QCOMPARE(library.errors[0], "\"" + in + "/b.json\" is skipped: \"" + in +
                                        "/a.json\" already defines the material \"lead glass\".");
        QCOMPARE(library.errors[1],
                 "Cannot read \"" + in + "/c.json\": density.value: expected a number, found \"heavy\".");
        QVERIFY2(library.errors[2].starts_with("Cannot read \"" + in + "/d.json\": The text is not JSON at line 1"),
                 library.errors[2].c_str());
    }
    void everyWrongTypeIsReportedWithItsPath() {
        const test::Schema schema("material.schema.json");
        QCOMPARE(test::unreportedMutation(barestJson(), schema, noneFits, presetFault), std::string());
    }
    void wrongValuesAreReported_data() {
        test::addWrongValueColumns();
        test::addWrongValue("format: expected \"rubble-material\", found \"rubble-project\".", "/format",
                            "\"rubble-project\"");
        test::addWrongValue(
            "The material has version 2, but this program reads versions up to 1; open it with a newer one.",
            "/version", "2");
        test::addWrongValue("The material has no name.", "/name", "\"\"");
        test::addWrongValue("Material \"glass\": the density is 0, but it must be from 0.001 to 1000000.",
                            "/density/value", "0");
        test::addWrongValue("Material \"glass\": the friction is 2, but its range goes from 0.4 to 0.94.",
                            "/friction/value", "2");
        test::addWrongValue("Material \"glass\": the restitution is 1.5, but it must be from 0 to 1.",
                            "/restitution/value", "1.5");
        test::addWrongValue("tensileStrength.range: expected an array of 2 numbers, found an array of 1.",
                            "/tensileStrength/range", "[1]");
        test::addWrongValue("fractureToughness: the key \"value\" is missing.", "/fractureToughness",
                            "{\"source\": \"a book\"}");
        test::addWrongValue("density: unknown key \"unit\".", "/density", "{\"value\": 2, \"unit\": \"t\"}");
        test::addWrongValue("Material \"glass\": the inside colour is 2, but it must be from 0 to 1.", "/inside",
                            "[0, 2, 0]");
        test::addWrongValue(
            "Material \"glass\": layer 1 of the pattern has the id 9; those of a preset are 1, 2, 3 and so on.",
            "/pattern/0/id", "9");
        test::addWrongValue("Material \"glass\": The roughness has 9 octaves, but it must have from 1 to 8.",
                            "/roughness", R"({"amplitude": 0.01, "frequency": 10, "octaves": 9, "randomSeed": 0})");
    }
    void wrongValuesAreReported() {
        QCOMPARE(presetFault(test::withWrongValue(glassJson())), std::string(QTest::currentDataTag()));
    }
    void invalidPresetIsNotSaved() {
        MaterialPreset preset = presetOf(emptyProject().materials[0], nullptr);
        preset.density.value = -1.0;
        QCOMPARE(saveMaterialPreset(folder() / "x.json", preset).error().message,
                 "Cannot write \"" + folder().string() +
                     "/x.json\": Material \"plaster\": the density is -1, but it must be from 0.001 to 1000000.");
        QVERIFY(!fs::exists(folder() / "x.json"));
    }
};

RUBBLE_TEST(MaterialPresetFileTest)
#include "MaterialPresetFileTest.moc"
