// Tests app/cli/verbs: what new writes passes export, check, audit and diff, for all materials and pattern kinds.
#include "app/cli/Cli.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/PatternSamples.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <sstream>

using namespace rubble;

namespace {

/// Runs a verb in this process; returns what it printed if it failed.
QString failureOf(const QStringList& arguments) {
    std::vector<std::string> texts;
    for (const QString& argument : arguments) texts.push_back(argument.toStdString());
    std::ostringstream out, err;
    const int exit = runCli(texts, {.in = 0, .out = out, .err = err});
    if (exit == kExitSuccess) return {};
    return QString::fromStdString(arguments.join(' ').toStdString() + ": " + out.str() + err.str());
}

/// Layers that fracture a wall by a sample; what only moves seeds or distances has seeds to work on.
std::vector<PatternLayer> layersOf(const LayerParameters& sample, Id& nextId) {
    std::vector<LayerParameters> parameters;
    const LayerRole role = kindOf(sample).role;
    if (role == LayerRole::Moves || role == LayerRole::Measures) parameters.push_back(UniformScatter{.count = 6});
    parameters.push_back(sample);
    std::vector<PatternLayer> layers;
    for (const LayerParameters& each : parameters)
        layers.push_back({.id = nextId++, .randomSeed = 7, .parameters = each});
    return layers;
}

const QStringList kPresets = QDir(RUBBLE_SOURCE_DIR "/resources/materials").entryList({"*.json"}, QDir::Files);

}  // namespace

class PresetPipelineTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_place;

    QString file() const { return m_place.filePath("wall.rubble"); }

    /// Returns the first failure of the verbs that follow new.
    QString pipelineFailure() {
        const QString packs = m_place.filePath("packs");
        for (const QStringList& arguments :
             {QStringList{"export", file(), "--out", packs, "--format", "obj"}, QStringList{"check", file()},
              QStringList{"check", packs}, QStringList{"audit", file()}, QStringList{"diff", file(), file()}}) {
            if (const QString failure = failureOf(arguments); !failure.isEmpty()) return failure;
        }
        return {};
    }

private slots:
    void init() {
        QDir(m_place.filePath("packs")).removeRecursively();
        QFile::remove(file());
    }
    void presetsPass_data() {
        QTest::addColumn<QString>("material");
        QVERIFY(kPresets.size() >= 8);
        for (const QString& preset : kPresets) QTest::newRow(qPrintable(preset)) << preset.chopped(5);
    }
    void presetsPass() {
        QFETCH(QString, material);
        QCOMPARE(failureOf({"new", file(), "--material", material}), QString());
        QCOMPARE(pipelineFailure(), QString());
    }
    void kindsPass_data() {
        QTest::addColumn<int>("sample");
        const std::vector<LayerParameters> samples = patternSamples();
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const std::string name = std::string(kindOf(samples[k]).name) + " " + std::to_string(k);
            QTest::newRow(name.c_str()) << static_cast<int>(k);
        }
    }
    /// Every kind in every material, on two levels in each third, with a gap in every other.
    void kindsPass() {
        QFETCH(int, sample);
        const LayerParameters parameters = patternSamples()[static_cast<std::size_t>(sample)];
        for (qsizetype k = 0; k < kPresets.size(); ++k) {
            init();
            QCOMPARE(failureOf({"new", file(), "--material", kPresets[k].chopped(5)}), QString());
            Project project = *loadProject(file().toStdString());
            Asset& wall = project.assets[0];
            wall.pattern.layers = layersOf(parameters, project.nextId);
            if (k % 3 == 0) wall.levels = {{.pattern = {layersOf(UniformScatter{.count = 3}, project.nextId)}}};
            if (k % 2 == 1) wall.shaping.gap = 0.003;
            QVERIFY(saveProject(file().toStdString(), project));
            QCOMPARE(pipelineFailure(), QString());
        }
    }
    /// Mortar between small fragments of a fragment, and none between the fragments of the whole.
    void mortarOfALevelPasses() {
        QCOMPARE(failureOf({"new", file()}), QString());
        Project project = *loadProject(file().toStdString());
        Asset& wall = project.assets[0];
        wall.pattern.layers = layersOf(UniformScatter{.count = 3}, project.nextId);
        wall.levels = {{.pattern = {layersOf(BrickBond{}, project.nextId)}}};
        QVERIFY(saveProject(file().toStdString(), project));
        QCOMPARE(pipelineFailure(), QString());
    }
};

RUBBLE_TEST_WITH(PresetPipelineTest, QCoreApplication)
#include "PresetPipelineTest.moc"
