// SPDX-License-Identifier: GPL-3.0-or-later
// The program as its users' scripts see it: exit codes, messages, names and bytes.
#include <QTest>

#include <algorithm>

#include <fcntl.h>
#include <unistd.h>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <csignal>
#include <cstdlib>

#include "tests/support/program.h"

using namespace drillwave::test;

class TestCommandLine : public QObject {
    Q_OBJECT

  private slots:
    void helpAndVersionAreEverywhere_data();
    void helpAndVersionAreEverywhere();
    void helpTellsOfWhateverHasAName_data();
    void helpTellsOfWhateverHasAName();
    void helpFindsEverydayWords_data();
    void helpFindsEverydayWords();
    void helpOptionBeforeACommandPrintsItsHelp();
    void mistakesGetOneLineAndTheirExitCode_data();
    void mistakesGetOneLineAndTheirExitCode();
    void mistakesAreToldInTheLanguageOfTheCommand();
    void pointsBeyondTheLimitAreTold();
    void pointsThatCannotBeAreEmptyAndTold_data();
    void pointsThatCannotBeAreEmptyAndTold();
    void oneSetTakesSeveralAssignments();
    void implausibleValuesAreRemarkedOnBeforeTheWork();
    void aNumberOfARepeatedSectionIsRemarkedOn();
    void aLongSolutionShowsItsTimeOnATerminal();
    void aFullDeviceIsToldOfByHelpToo();
    void aNameThatIsNotUtf8IsRefused();
    void longPathsAreShortenedInMessages();
    void everyProblemOfAFileIsALine();
    void validateIsSilentAboutGoodFiles();
    void examplesAreListedAndWritten();
    void resettingTheWindowForgetsItsChoices();
    void aMissingDisplayIsToldInOneLine_data();
    void aMissingDisplayIsToldInOneLine();
    void aWindowWithoutAHomeMakesNoFolders();
};

void TestCommandLine::helpAndVersionAreEverywhere_data() {
    QTest::addColumn<QString>("command");
    for (const char* command :
         {"", "run", "sweep", "table", "gap", "curve", "map", "drill", "design", "signal", "report", "join",
          "thrust", "figures", "accuracy", "stability", "validate", "examples", "presets"})
        QTest::newRow(*command ? command : "program") << command;
}

void TestCommandLine::helpAndVersionAreEverywhere() {
    QFETCH(QString, command);
    const QStringList words = command.isEmpty() ? QStringList() : QStringList{command};
    const Finished help = run(words + QStringList{"--help"});
    QCOMPARE(help.exitCode, 0);
    QVERIFY(help.out.contains("Usage: drillwave"));
    for (const QByteArray& line : help.out.split('\n'))
        QVERIFY2(command.isEmpty() || QString::fromUtf8(line).size() <= 80, line.constData());
    QVERIFY2(QString::fromUtf8(help.out).toUtf8() == help.out && help.out.endsWith('\n') &&
                 !help.out.contains('\0'),
             help.out);
    QCOMPARE(help.error, QByteArray());
    QCOMPARE(run(words + QStringList{"-h"}).out, help.out);
    // Other things of the same name follow: `thrust` is an output, too.
    QVERIFY(run(QStringList{"help"} + words).out.startsWith(help.out));
    const Finished version = run(words + QStringList{"--version"});
    QCOMPARE(version.exitCode, 0);
    QVERIFY(QRegularExpression("^drillwave \\d+\\.\\d+\\.\\d+(\\+\\d+\\.g[0-9a-f]+)?\n$")
                .match(version.out)
                .hasMatch());
    QCOMPARE(run({"version"}).out, version.out);
}

void TestCommandLine::helpTellsOfWhateverHasAName_data() {
    QTest::addColumn<QStringList>("topic");
    QTest::addColumn<QString>("told");
    QTest::newRow("a parameter") << QStringList{"bit_rock.gamma"} << "in (0, 1]";
    QTest::newRow("a number of a section") << QStringList{"string.rod.length"} << "Length of the section";
    QTest::newRow("a word") << QStringList{"pulse.shape"} << "half_sine";
    QTest::newRow("an output") << QStringList{"peak_force"} << "multiple of: F0";
    QTest::newRow("a command that is an output, too") << QStringList{"thrust"} << "in SI: N";
    QTest::newRow("a chapter") << QStringList{"glossary"} << "Rod and string";
    QTest::newRow("a section") << QStringList{"theory", "10"} << "(T34)";
    QTest::newRow("a section with its sign") << QStringList{"theory", "§2.1"} << "`trapezoid`";
    QTest::newRow("a symbol") << QStringList{"β"} << "k t0/Z";
    QTest::newRow("an alert") << QStringList{"super_rebound"} << "e > 1";
    QTest::newRow("the last part of a key") << QStringList{"gamma"} << "See also `bit_rock.gamma`.";
}

void TestCommandLine::helpTellsOfWhateverHasAName() {
    QFETCH(QStringList, topic);
    QFETCH(QString, told);
    const Finished help = run(QStringList{"help"} + topic);
    QCOMPARE(help.exitCode, 0);
    QCOMPARE(help.error, QByteArray());
    QVERIFY2(help.out.contains(told.toUtf8()) && help.out.endsWith('\n'), help.out);
}

// Each word finds a place of the manual, a section of that very title, or the commands that have an option.
void TestCommandLine::helpFindsEverydayWords_data() {
    QTest::addColumn<QString>("place");
    for (const auto& [words, place] : {std::pair{"feed", "glossary 7"},
                                       {"rock", "files 1.4"},
                                       {"hammer", "theory 2.1"},
                                       {"bit", "glossary 3"},
                                       {"string", "files 1.3"},
                                       {"coupling", "glossary 7"},
                                       {"damper", "drilling 5"},
                                       {"blow", "files 1.1"},
                                       {"penetration", "glossary 7"},
                                       {"fatigue", "files 1.3"},
                                       {"error", "theory 11"},
                                       {"rop", "penetration_rate"},
                                       {"csv", "§6 CSV"},
                                       {"json", "§5 JSON"},
                                       {"exit", "commands 6"},
                                       {"exit codes", "§6 Exit codes"},
                                       {"slurm", "commands 4.12"},
                                       {"shard", "sweep, table, map"},
                                       {"signal", "drillwave signal RECORD"},
                                       {"measured", "files 8"},
                                       {"import", "files 8"},
                                       {"plots", "accuracy, stability"},
                                       {"language", "commands 1"},
                                       {"scenario", "files 1"},
                                       {"units", "§2.1 Units"},
                                       {"--set", "--set KEY=VALUE"},
                                       {"-j", "threads"},
                                       {"--language", "--language CODE"},
                                       {"TMPDIR", "commands 2"},
                                       {"DRILLWAVE_LANGUAGE", "commands 1"},
                                       {"getting started", "tutorial"}})
        QTest::newRow(words) << QString::fromUtf8(place);
}

void TestCommandLine::helpFindsEverydayWords() {
    QFETCH(QString, place);
    const QString words = QTest::currentDataTag();
    const Finished help = run(QStringList{"help"} + words.split(' '));
    QCOMPARE(help.exitCode, 0);
    QVERIFY2(help.out.contains(place.toUtf8()), help.out);
    const qsizetype list = help.out.indexOf("drillwave help …");
    const QByteArray places = list < 0 ? QByteArray() : help.out.mid(list);
    QVERIFY2(places.count('\n') < 40, places);
    QVERIFY(!help.out.startsWith("files §5 JSON"));
    // The table of commands §4.15 has words as examples, and explains none.
    QVERIFY2(!help.out.contains("commands §4.15 help\n"), help.out);
}

void TestCommandLine::helpOptionBeforeACommandPrintsItsHelp() {
    for (const char* option : {"--help", "-h"})
        QCOMPARE(run({option, "sweep"}).out, run({"sweep", "--help"}).out);
    QVERIFY(run({"help", "help"}).out.startsWith("Usage: drillwave help [TOPIC]\n"));
    QCOMPARE(run({"--help", "theory", "10"}).out, run({"help", "theory", "10"}).out);
}

void TestCommandLine::mistakesGetOneLineAndTheirExitCode_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("part");
    const QString paper = example("paper_fig4a");
    const QString drill = example("t38_medium_rock");
    const QString cases = QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/reference.csv");
    QTest::newRow("mistyped command") << QStringList{"swep"} << 2 << "did you mean `drillwave sweep`?";
    QTest::newRow("no such file or command") << QStringList{"nothing.yaml"} << 3 << "No such file";
    QTest::newRow("unknown option") << QStringList{"--frobnicate"} << 2 << "unknown option `--frobnicate`";
    QTest::newRow("run without a file") << QStringList{"run"} << 2 << "needs FILE";
    QTest::newRow("run with two files") << QStringList{"run", paper, drill} << 2 << "unexpected argument";
    QTest::newRow("mistyped option") << QStringList{"run", paper, "--jsn"} << 2 << "did you mean `--json`?";
    QTest::newRow("option of other programs")
        << QStringList{"sweep", paper, "--vary", "beta=1,2", "--jobs", "2"} << 2 << "did you mean `-j`?";
    QTest::newRow("folder by another name")
        << QStringList{"run", paper, "--output=x"} << 2 << "did you mean `-o`?";
    QTest::newRow("unknown letter") << QStringList{"run", paper, "-x"} << 2
                                    << "unknown option `-x`; --help lists the options";
    QTest::newRow("option without its value")
        << QStringList{"run", paper, "--set"} << 2 << "needs a value: KEY=VALUE";
    QTest::newRow("switch with a value") << QStringList{"run", paper, "--json=1"} << 2 << "takes no value";
    QTest::newRow("option twice") << QStringList{"run", paper, "--json", "--json"} << 2 << "given twice";
    QTest::newRow("method that does not exist")
        << QStringList{"run", paper, "--method", "guess"} << 2 << "exact, lattice, closed_form";
    QTest::newRow("segments of no lattice")
        << QStringList{"run", paper, "--segments", "100"} << 2 << "add --method lattice";
    QTest::newRow("too few segments")
        << QStringList{"run", paper, "--method", "lattice", "--segments", "1"} << 2 << "from 10 to 1000000";
    QTest::newRow("closed form of an inelastic rock")
        << QStringList{"run", example("paper_fig4b"), "--method", "closed_form"} << 2 << "not gamma = 0.1";
    QTest::newRow("closed form of overlapping waves")
        << QStringList{"run", paper, "--method", "closed_form", "--set", "beta=0.001"} << 6 << "overlap";
    QTest::newRow("lattice too coarse for the rock")
        << QStringList{"run", paper, "--method", "lattice", "--set", "beta=1e9"} << 6
        << "it takes at least 5e+09 segments";
    QTest::newRow("ladder with a hole")
        << QStringList{"accuracy", paper, "--segments", "100,,200"} << 2 << "as in 100,1000,10000";
    QTest::newRow("accuracy of what cannot be solved")
        << QStringList{"accuracy", paper, "--set", "beta=1e-300"} << 6 << "could not be solved";
    QTest::newRow("accuracy without a file") << QStringList{"accuracy"} << 2 << "needs FILE";
    QTest::newRow("setting without a value")
        << QStringList{"run", paper, "--set", "beta"} << 2 << "needs KEY=VALUE";
    QTest::newRow("setting of nothing")
        << QStringList{"run", paper, "--set", "bet=1"} << 2 << "did you mean `beta`?";
    QTest::newRow("setting out of range")
        << QStringList{"run", paper, "--set", "gamma=1.3"} << 5 << "gamma = 1.3 (must be in (0, 1])";
    QTest::newRow("setting without unit")
        << QStringList{"run", drill, "--set", "rod.length=3"} << 5 << "has no unit";
    QTest::newRow("setting that is a file") << QStringList{"run", drill, "--set", "pulse.file=blow.csv"} << 2
                                            << "write it into the scenario file";
    // The stiffness that it takes is beyond the largest double: solved was another beta.
    QTest::newRow("setting that would not be kept")
        << QStringList{"run", drill, "--set", "beta=1e301"} << 5 << "beta = 1e301 (cannot be stored";
    QTest::newRow("gap of too many periods")
        << QStringList{"run", paper, "--set", "delta=1e17"} << 5
        << "delta = 1e17 (must be in [0, 1e+09]: in a larger one, double";
    QTest::newRow("rod of too many blows")
        << QStringList{"run", paper, "--set", "tau=1e300"} << 5 << "tau = 1e300 (must be in (0, 1e+09]:";
    QTest::newRow("gap in units of too many periods")
        << QStringList{"run", drill, "--set", "bit_rock.gap=1e300km"} << 5
        << "it follows from the other values";
    QTest::newRow("contact too late to be told") << QStringList{"run", paper, "--set", "delta=1e8", "tau=1e6"}
                                                 << 5 << "the bit meets the rock after 2";
    const auto axisAndSetting = [&](const char* name, const char* axis, const char* setting) {
        QTest::newRow(name) << QStringList{"sweep", drill, "--vary", axis, "--set", setting} << 2
                            << QStringLiteral("--vary %1 and --set %2 set the same thing")
                                   .arg(QLatin1String(axis), QLatin1String(setting));
    };
    axisAndSetting("axis that is set", "beta=1,2", "beta=3");
    axisAndSetting("axis of a length that is set", "tau=1,2", "rod.length=3m");
    const auto twoSettings = [&](const char* name, const char* first, const char* second) {
        QTest::newRow(name) << QStringList{"run", drill, "--set", first, "--set", second} << 2
                            << QStringLiteral("--set %1 and --set %2 set the same thing")
                                   .arg(QLatin1String(first), QLatin1String(second));
    };
    twoSettings("setting twice", "beta=0.5", "beta=0.6");
    twoSettings("settings of one length", "tau=3", "rod.length=3m");
    twoSettings("settings of one stiffness", "bit_rock.stiffness=100MN/m", "beta=0.5");
    twoSettings("settings of one gap", "delta=1", "bit_rock.gap=1mm");
    twoSettings("settings of one elasticity", "gamma=0.5", "bit_rock.gamma=0.5");
    twoSettings("settings of one impulse", "pulse.impulse=51N s", "pulse.force=255kN");
    twoSettings("settings of two shapes", "pulse.shape=triangular", "pulse.shape=half_sine");
    QTest::newRow("settings that do not go together")
        << QStringList{"run", drill, "--set", "rod.bore=50mm"} << 5 << "must be less than the diameter";
    QTest::newRow("plots without a folder")
        << QStringList{"run", paper, "--plots", "png"} << 2 << "add -o DIR";
    QTest::newRow("unknown plot format")
        << QStringList{"run", paper, "--plots", "gif", "-o", "x"} << 2 << "choose from png, svg, pdf";
    QTest::newRow("SI files of groups")
        << QStringList{"run", paper, "--si", "-o", "x"} << 2 << "has no SI units";
    QTest::newRow("missing scenario") << QStringList{"run", "nothing.yaml"} << 3 << "nothing.yaml";
    QTest::newRow("CSV without a scenario") << QStringList{"run", cases} << 3 << "holds no scenario";
    QTest::newRow("folder as a scenario") << QStringList{"run", QDir::tempPath()} << 3 << "";
    QTest::newRow("folder that cannot be made")
        << QStringList{"run", paper, "-o", "/dev/null/x"} << 4 << "cannot be made";
    QTest::newRow("case beyond the limit of work")
        << QStringList{"run", paper, "--set", "beta=1e-300"} << 6 << "could not be solved";
    QTest::newRow("sweep of nothing from no file")
        << QStringList{"sweep", "nowhere.yaml"} << 2 << "needs --vary";
    QTest::newRow("sweep of nothing") << QStringList{"sweep", paper} << 2 << "needs --vary";
    QTest::newRow("axis of nothing") << QStringList{"sweep", paper, "--vary", "bta=1,2"} << 2
                                     << "did you mean `beta`?";
    QTest::newRow("axis out of range")
        << QStringList{"sweep", paper, "--vary", "beta=0:1:3"} << 5 << "beta = 0 (must be greater than 0)";
    QTest::newRow("axis invalid all over")
        << QStringList{"sweep", drill, "--vary", "rod.bore=40mm:50mm:3"} << 5 << "at rod.bore = 40 mm";
    const QString string = example("t38_string");
    QTest::newRow("name and place of one section")
        << QStringList{"run", string, "--set", "string.rod.length=3m", "string.3.length=2m"} << 2
        << "set one section: section 3 of the string is called rod; give one of them";
    QTest::newRow("shape of a string")
        << QStringList{"sweep", string, "--vary", "pulse.shape=half_sine,piston"} << 5
        << "does not apply here: only for a force instead of the hammer";
    QTest::newRow("rock as of air") << QStringList{"run", string, "--set", "beta=1e-300"} << 5
                                    << "bit_rock.stiffness";
    QTest::newRow("number beyond double precision")
        << QStringList{"run", example("reference_case"), "--set", "tau=5e-324"} << 6
        << "beyond the range of double precision";
    QTest::newRow("mistyped output") << QStringList{"sweep",    paper,       "--vary",
                                                    "beta=1,2", "--outputs", "peak_forc"}
                                     << 2 << "did you mean `peak_force`?";
    QTest::newRow("no threads") << QStringList{"sweep", paper, "--vary", "beta=1,2", "-j", "0"} << 2
                                << "whole number from 1";
    QTest::newRow("shard beyond the last")
        << QStringList{"sweep", paper, "--vary", "beta=1,2", "--shard", "3/2"} << 2 << "needs I/N";
    QTest::newRow("folder that does not exist")
        << QStringList{"sweep", paper, "--vary", "beta=1,2", "-o", "/nowhere/x.csv"} << 4 << "/nowhere/x.csv";
    QTest::newRow("full device") << QStringList{"sweep", paper, "--vary", "beta=1,2", "-o", "/dev/full"} << 4
                                 << "No space left";
    QTest::newRow("table without cases") << QStringList{"table", paper} << 2 << "needs FILE CASES.csv";
    QTest::newRow("missing cases") << QStringList{"table", paper, "nothing.csv"} << 3 << "nothing.csv";
    QTest::newRow("cases from a device")
        << QStringList{"table", paper, "/dev/null"} << 5 << "is empty; its first row must name parameters";
    QTest::newRow("cases in a folder")
        << QStringList{"table", paper, QDir::tempPath()} << 3 << "not a regular file";
    QTest::newRow("scenario and cases from one pipe")
        << QStringList{"table", "-", "-"} << 2 << "both standard input";
    QTest::newRow("nearly an example")
        << QStringList{"run", "t38_medium_rok"} << 3 << "did you mean the example `t38_medium_rock`?";
    QTest::newRow("the beginning of an example")
        << QStringList{"run", "t38_m"} << 3 << "did you mean the example `t38_medium_rock`?";
    QTest::newRow("the beginning of two examples")
        << QStringList{"run", "t38"} << 3 << "did you mean the example `t38_medium_rock` or `t38_string`?";
    QTest::newRow("output twice") << QStringList{"sweep",    paper,       "--vary",
                                                 "beta=1,2", "--outputs", "cor,impulse,cor"}
                                  << 2 << "`cor` is given twice";
    QTest::newRow("all outputs and one more")
        << QStringList{"sweep", paper, "--vary", "beta=1,2", "--outputs", "cor,all"} << 2
        << "give nothing else";
    QTest::newRow("preset that does not exist")
        << QStringList{"run", drill, "--rock", "medium rok"} << 2 << "did you mean `medium rock`?";
    QTest::newRow("preset of several names")
        << QStringList{"run", drill, "--rod", "T38"} << 2 << "`T38, round 38 mm`, `T38, round 39 mm`";
    QTest::newRow("preset with another number")
        << QStringList{"run", drill, "--rod", "T52"} << 2 << "did you mean `T51`?";
    QTest::newRow("preset for groups")
        << QStringList{"run", paper, "--rod", "T51"} << 2 << "presets need a scenario in physical units";
    QTest::newRow("presets of nothing")
        << QStringList{"run", drill, "--presets", "x.yaml"} << 2 << "add one of them";
    QTest::newRow("an output by other words")
        << QStringList{"sweep", drill, "--vary", "gamma=0.1,0.2", "--outputs", "drilling_rate"} << 2
        << "did you mean `drill_penetration_rate`?";
    QTest::newRow("missing presets") << QStringList{"presets", "nothing.yaml"} << 3 << "nothing.yaml";
    QTest::newRow("presets and scenario of one input")
        << QStringList{"run", "-", "--presets", "-", "--rod", "T51"} << 2 << "standard input";
    QTest::newRow("version of something") << QStringList{"version", "x"} << 2 << "unexpected argument `x`";
    QTest::newRow("version with an option")
        << QStringList{"version", "--nosuch"} << 2 << "unexpected argument";
    QTest::newRow("help for two commands")
        << QStringList{"help", "run", "x"} << 2 << "unexpected argument `x`";
    QTest::newRow("examples that overwrite nothing") << QStringList{"examples", "--force"} << 2 << "add -o";
    QTest::newRow("gap of a drill string")
        << QStringList{"gap", "t38_string"} << 5 << "curve FILE --along bit_rock.gap=";
    QTest::newRow("what a set makes impossible")
        << QStringList{"run", drill, "--set", "rod.bore=40mm"} << 5 << "drillwave run: ";
    QTest::newRow("a blow of too many pieces")
        << QStringList{"run", drill, "--set", "pulse.duration=200s", "--work-limit", "50000"} << 6
        << "--work-limit, now 50000, permits more";
    QTest::newRow("a blow of very many pieces") << QStringList{"run", drill, "--set", "pulse.duration=200s"}
                                                << 6 << "--work-limit, now 1000000, permits more";
    QTest::newRow("a thrust of too many pieces")
        << QStringList{"thrust", drill, "--set", "pulse.duration=200s", "--work-limit", "50000"} << 6
        << "--work-limit, now 50000, permits more";
    QTest::newRow("a thrust of very many pieces")
        << QStringList{"thrust", drill, "--set", "pulse.duration=200s"} << 6
        << "--work-limit, now 1000000, permits more";
    QTest::newRow("a thrust of a string of too many cells")
        << QStringList{"thrust", "t51_string", "--work-limit", "1"} << 6
        << "--work-limit, now 1, permits more";
    QTest::newRow("a report of too many pieces")
        << QStringList{"report", drill, "--set", "pulse.duration=200s", "--work-limit", "50000", "-o", "-"}
        << 6 << "--work-limit, now 50000, permits more";
    QTest::newRow("a string of too many cells")
        << QStringList{"run", "t51_string", "--work-limit", "1"} << 6 << "--work-limit, now 1, permits more";
    QTest::newRow("lattices that would take hours")
        << QStringList{"accuracy", paper, "--segments", "100,1000000"} << 2
        << "more than --work-limit, now 1000000000";
    QTest::newRow("lattices beyond what is permitted")
        << QStringList{"accuracy", paper, "--segments", "100", "--work-limit", "1000"} << 2
        << "more than --work-limit, now 1000";
    QTest::newRow("help for nothing") << QStringList{"help", "rn"} << 2 << "did you mean `run`?";
    QTest::newRow("help for no section")
        << QStringList{"help", "theory", "99"} << 2 << "`99` is not a section of theory, which has §1, §2";
    QTest::newRow("two forms of the columns")
        << QStringList{"run", drill, "--si", "--dimensionless", "-o", "x"} << 2 << "cannot be combined";
    QTest::newRow("gap in SI of groups")
        << QStringList{"gap", paper, "--si", "-o", "-"} << 2 << "has no SI units";
    QTest::newRow("JSON without a scenario")
        << QStringList{"run", "/dev/null/x.json"} << 3 << "cannot be opened";
    QTest::newRow("gap without a file") << QStringList{"gap"} << 2 << "needs FILE";
    QTest::newRow("mean of a gap that does not scatter")
        << QStringList{"gap", paper, "--gap-mean", "0.3"} << 2 << "needs --gap-deviation";
    QTest::newRow("scatter without unit")
        << QStringList{"gap", drill, "--gap-deviation", "0.3"} << 5 << "has no unit";
    QTest::newRow("scatter in the wrong unit")
        << QStringList{"gap", paper, "--gap-deviation", "0.3 mm"} << 5 << "--gap-deviation = 0.3 mm";
    QTest::newRow("scatter of nothing")
        << QStringList{"gap", paper, "--gap-deviation", "0"} << 5 << "must be from 1e-06 to 100";
    QTest::newRow("negative mean gap")
        << QStringList{"gap", drill, "--gap-deviation", "1mm", "--gap-mean=-1mm"} << 5 << "must be from 0 mm";
    QTest::newRow("gap that the hammer never leaves")
        << QStringList{"gap", paper, "--set", "tau=1e-7"} << 6 << "could not be solved at all gaps";
    QTest::newRow("thrust of groups")
        << QStringList{"thrust", paper} << 5 << "needs a scenario in physical units";
    QTest::newRow("frequency without unit")
        << QStringList{"thrust", drill, "--frequency", "40:50:3"} << 5 << "has no unit";
    QTest::newRow("frequency of nothing")
        << QStringList{"thrust", drill, "--frequency", "40Hz:50Hz:0"} << 2 << "--frequency: ";
    QTest::newRow("thrust file without a table")
        << QStringList{"thrust", drill, "-o", "x.csv"} << 2 << "add --along";
    QTest::newRow("figures without a folder") << QStringList{"figures"} << 2 << "needs -o DIR";
    QTest::newRow("figures of a file")
        << QStringList{"figures", paper, "-o", "x"} << 2 << "unexpected argument";
    QTest::newRow("figures into no folder")
        << QStringList{"figures", "-o", "/dev/null/x"} << 4 << "cannot be made";
    QTest::newRow("unknown example") << QStringList{"examples", "t38_medium"} << 2 << "t38_medium";
}

// Keys, names of files and the exit code are the same in all of them.
void TestCommandLine::mistakesAreToldInTheLanguageOfTheCommand() {
    const QStringList words{"run", example("t38_medium_rock"), "--set", "rod.length=-1 m"};
    const Finished english = run(words);
    QCOMPARE(english.exitCode, 5);
    QVERIFY2(english.error.endsWith("rod.length = -1 m (must be greater than 0)\n"), english.error);
    const Finished german = run(words + QStringList{"--language", "de"});
    QCOMPARE(german.exitCode, 5);
    QVERIFY2(german.error.endsWith("rod.length = -1 m (muss größer als 0 sein)\n"), german.error);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DRILLWAVE_LANGUAGE", "de");
    QCOMPARE(run(words, environment).error, german.error);

    QTemporaryDir place;
    const QString path = place.filePath("bad.yaml");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) &&
            file.write("drillwave: 1\ndimensionless: {beta: -1, gamma: 1, tau: 4}\n") > 0);
    file.close();
    for (const char* command : {"run", "validate"}) {
        const Finished read = run({command, path, "--language", "de"});
        QCOMPARE(read.exitCode, 5);
        QVERIFY2(read.error.contains("beta = -1 (muss größer als 0 sein)"), read.error);
    }
    const Finished remark =
        run({"run", example("t38_medium_rock"), "--set", "rod.density=9001kg/m^3", "--language", "de"});
    QCOMPARE(remark.exitCode, 0);
    QVERIFY2(remark.error.contains("ρ = 9001 kg/m^3 liegt außerhalb ihres üblichen Bereichs"), remark.error);
}

void TestCommandLine::pointsBeyondTheLimitAreTold() {
    const Finished finished = run({"thrust", example("t38_medium_rock"), "--along",
                                   "pulse.duration=200us,200s", "--work-limit", "1000"});
    QCOMPARE(finished.exitCode, 6);
    QVERIFY2(finished.error.contains("1 of 2 points") &&
                 finished.error.contains("--work-limit, now 1000, permits more"),
             finished.error);
}

void TestCommandLine::mistakesGetOneLineAndTheirExitCode() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, part);
    const Finished finished = run(words);
    QCOMPARE(finished.exitCode, exitCode);
    QCOMPARE(finished.out, QByteArray());
    QVERIFY2(QString::fromUtf8(finished.error).contains(part), finished.error);
    QVERIFY(finished.error.endsWith('\n'));
    // Remarks on values come before the work that they may cost; the error is one line.
    QStringList lines = QString::fromUtf8(finished.error).trimmed().split('\n');
    lines.removeIf([](const QString& line) { return line.contains(": warning: "); });
    QCOMPARE(lines.size(), 1);
}

void TestCommandLine::pointsThatCannotBeAreEmptyAndTold_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("empty");
    QTest::addColumn<int>("filled");
    QTest::addColumn<QString>("part");
    const QString drill = example("t38_medium_rock"), string = example("t38_string");
    QTest::newRow("axis that would not be kept")
        << QStringList{"sweep", drill, "--vary", "beta=1:1e301:3:log"} << 1 << 2 << "beta cannot be stored";
    QTest::newRow("axis invalid at its end")
        << QStringList{"sweep", drill, "--vary", "rod.bore=1mm:40mm:3"} << 1 << 2
        << "1 row: rod.bore must be less than the diameter of 38 mm";
    QTest::newRow("place that repeats leave none")
        << QStringList{"sweep", string, "--vary", "string.repeat=1:3:3", "string.9.length=60mm,70mm"} << 4
        << 2 << "4 of 6 rows could not be solved";
}

void TestCommandLine::pointsThatCannotBeAreEmptyAndTold() {
    QFETCH(QStringList, words);
    QFETCH(int, empty);
    QFETCH(int, filled);
    QFETCH(QString, part);
    const Finished finished = run(words);
    QCOMPARE(finished.exitCode, 6);
    QVERIFY2(QString::fromUtf8(finished.error).contains(part), finished.error);
    const QList<QByteArray> rows = finished.out.trimmed().split('\n').mid(1);
    const auto isEmpty = [](const QByteArray& row) { return row.endsWith(','); };
    QCOMPARE(std::ranges::count_if(rows, isEmpty), empty);
    QCOMPARE(rows.size(), empty + filled);
}

void TestCommandLine::oneSetTakesSeveralAssignments() {
    const QString paper = example("paper_fig4a");
    const QByteArray several = run({"gap", paper, "--set", "beta=0.7", "gamma=0.3", "tau=3"}).out;
    QVERIFY(several.contains("beta 0.7  gamma 0.3  tau 3"));
    QCOMPARE(run({"gap", "--set=beta=0.7", "gamma=0.3", "tau=3", "--", paper}).exitCode, 0);
    const Finished refused = run({"run", paper, "--set", "beta=0.7", "gamma=3"});
    QCOMPARE(refused.exitCode, 5);
    QVERIFY2(refused.error.startsWith("drillwave run: --set gamma=3: "), refused.error);
}

// A mistyped unit may make a solution long: that is said first.
void TestCommandLine::implausibleValuesAreRemarkedOnBeforeTheWork() {
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(QStringLiteral(DRILLWAVE_PROGRAM), {"run", example("t38_medium_rock"), "--set",
                                                      "pulse.duration=200s", "--work-limit", "30000000"});
    QByteArray error;
    while (!error.contains('\n') && process.waitForReadyRead(60000)) error += process.readAllStandardError();
    error += process.readAllStandardError();
    QVERIFY2(
        error.contains("t38_medium_rock.yaml: warning: The input duration t0 = 200 s is outside its typical"),
        error);
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 130);
    for (const char* command : {"gap", "thrust"}) {
        const Finished finished =
            run({command, example("t38_medium_rock"), "--set", "rod.density=9001kg/m^3"});
        QCOMPARE(finished.exitCode, 0);
        QVERIFY2(finished.error.contains(
                     "warning: The input density ρ = 9001 kg/m^3 is outside its typical range"),
                 finished.error);
    }
}

// The time is shown on a terminal, and only there.
void TestCommandLine::aNumberOfARepeatedSectionIsRemarkedOn() {
    const QByteArray note =
        "note: string.2.loss sets 1st to 3rd coupling, which is one section with a repeat";
    const QString string = QStringLiteral("t38_string");
    QVERIFY(run({"run", string, "--set", "string.2.loss=10%"}).error.contains(note));
    QVERIFY(run({"sweep", string, "--vary", "string.2.loss=5%,10%", "--outputs", "efficiency"})
                .error.contains(note));
    QVERIFY(!run({"run", string, "--set", "string.coupling.loss=10%"}).error.contains("note:"));
}

void TestCommandLine::aLongSolutionShowsItsTimeOnATerminal() {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    const bool isOpen = terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0;
    const QByteArray name = isOpen ? ::ptsname(terminal) : nullptr;
    if (::access(name.constData(), R_OK | W_OK) != 0)
        QSKIP("there are no terminals to be had here: /dev/pts is not mounted");
    QProcess process;
    process.setChildProcessModifier([&name] {
        const int other = ::open(name.constData(), O_RDWR | O_NOCTTY);
        ::dup2(other, STDERR_FILENO);
        ::close(other);
    });
    process.start(QStringLiteral(DRILLWAVE_PROGRAM), {"run", example("t38_medium_rock"), "--set",
                                                      "pulse.duration=200s", "--work-limit", "30000000"});
    QVERIFY(process.waitForStarted());
    QByteArray shown;
    for (int reads = 0; reads < 50 && !shown.contains("solving for 2 s; Ctrl-C ends it"); ++reads) {
        char bytes[1024];
        const auto size = ::read(terminal, bytes, sizeof bytes);
        if (size <= 0) break;
        shown += QByteArray(bytes, static_cast<qsizetype>(size));
    }
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60000));
    ::close(terminal);
    QVERIFY2(shown.contains("solving for 2 s; Ctrl-C ends it"), shown);
    QCOMPARE(process.exitCode(), 130);
}

void TestCommandLine::aFullDeviceIsToldOfByHelpToo() {
    for (const char* option : {"--help", "--version"}) {
        QProcess process;
        process.setStandardOutputFile("/dev/full");
        process.start(QStringLiteral(DRILLWAVE_PROGRAM), {option});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 4);
        QCOMPARE(process.readAllStandardError(),
                 QByteArray("drillwave: standard output: cannot be written: No space left on device\n"));
    }
}

void TestCommandLine::longPathsAreShortenedInMessages() {
    const QString path = QStringLiteral("/nowhere/") + QStringLiteral("ü").repeated(3000) + "/end.yaml";
    for (const QStringList& words : {QStringList{"run", path}, {"run", example("paper_fig4a"), "-o", path}}) {
        const Finished finished = run(words);
        QVERIFY(finished.exitCode == 3 || finished.exitCode == 4);
        QVERIFY2(finished.error.size() < 400 && finished.error.contains("/end.yaml: "), finished.error);
        QVERIFY(QString::fromUtf8(finished.error).toUtf8() == finished.error);
    }
}

void TestCommandLine::aNameThatIsNotUtf8IsRefused() {
    const QTemporaryDir folder;
    QProcess shell;
    shell.start(
        "sh", {"-c", QStringLiteral("cd %1; exec %2 sweep %3 --vary beta=1,2 -o \"$(printf 'bad\\377.csv')\"")
                         .arg(folder.path(), QStringLiteral(DRILLWAVE_PROGRAM), example("paper_fig4a"))});
    QVERIFY(shell.waitForFinished());
    QCOMPARE(shell.exitCode(), 4);
    QVERIFY(shell.readAllStandardError().contains("the name is not UTF-8"));
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TestCommandLine::everyProblemOfAFileIsALine() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("bad.yaml");
    write(path,
          "drillwave: 1\n"
          "dimensionless: {beta: 0.5, gamma: 1.3, tau: 10, delta: -1}\n"
          "pulse: {shape: square}\n");
    for (const char* command : {"validate", "run"}) {
        const Finished finished = run({command, path});
        QCOMPARE(finished.exitCode, 5);
        const QStringList lines = QString::fromUtf8(finished.error).trimmed().split('\n');
        QCOMPARE(lines.size(), 3);
        QVERIFY2(lines[0].startsWith(path + ":2:") && lines[0].contains("gamma = 1.3 (must be in (0, 1])"),
                 finished.error);
        QVERIFY(lines[1].startsWith(path + ":2:") && lines[1].contains("delta"));
        QVERIFY(lines[2].startsWith(path + ":3:") && lines[2].contains("square"));
    }
}

void TestCommandLine::validateIsSilentAboutGoodFiles() {
    const Finished finished = run({"validate", example("paper_fig4a"), example("t51_soft_rock")});
    QCOMPARE(finished.exitCode, 0);
    QCOMPARE(finished.out + finished.error, QByteArray());
}

void TestCommandLine::examplesAreListedAndWritten() {
    const Finished list = run({"examples"});
    QCOMPARE(list.exitCode, 0);
    const QTemporaryDir folder;
    const QString inside = folder.filePath("new");
    QCOMPARE(run({"examples", "-o", inside}).exitCode, 0);
    const QStringList files = QDir(inside).entryList(QDir::Files);
    QCOMPARE(files.size(), list.out.count('\n'));
    for (const QString& file : files) {
        QVERIFY(list.out.contains(file.chopped(5).toUtf8()));
        QCOMPARE(read(inside + "/" + file), read(example(file.chopped(5))));
    }
    QCOMPARE(run({"examples", "-o", inside}).exitCode, 4);
    QCOMPARE(run({"examples", "-o", inside, "--force"}).exitCode, 0);
    for (const QStringList& words : {QStringList{"t38_string"}, QStringList{"t38_string", "-o", "-"}})
        QCOMPARE(run(QStringList{"examples"} + words).out, read(example("t38_string")));
}

void TestCommandLine::resettingTheWindowForgetsItsChoices() {
    QVERIFY(run({"--help"}).out.contains("--reset-ui"));
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("drillwave"));
    const QString settings = folder.filePath("drillwave/drillwave.conf");
    write(settings, "[General]\nrecentFiles=/a.yaml\n\n[window]\nunits=dimensionless\n");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", folder.path());
    environment.insert("XDG_DATA_HOME", folder.path());
    QProcess window;
    window.setProcessEnvironment(environment);
    window.start(QStringLiteral(DRILLWAVE_PROGRAM), {"-platform", "offscreen", "--reset-ui"});
    QTRY_VERIFY_WITH_TIMEOUT(!read(settings).contains("units"), 30000);
    QVERIFY(read(settings).contains("recentFiles=/a.yaml"));
    window.kill();
    QVERIFY(window.waitForFinished());
}

void TestCommandLine::aMissingDisplayIsToldInOneLine_data() {
    QTest::addColumn<QString>("display");
    QTest::newRow("none") << "";
    QTest::newRow("one that does not answer") << ":9977";
}

void TestCommandLine::aMissingDisplayIsToldInOneLine() {
    QFETCH(QString, display);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
    if (!display.isEmpty()) environment.insert("DISPLAY", display);
    const Finished finished = run({}, environment);
    QCOMPARE(finished.exitCode, 2);
    QCOMPARE(finished.error.count('\n'), 1);
    QVERIFY(finished.error.contains("-platform offscreen") && finished.error.contains("drillwave run FILE"));
    QVERIFY2(display.isEmpty() || finished.error.contains("display :9977 cannot be reached"), finished.error);
    QVERIFY2(!finished.error.contains("Reinstalling"), finished.error);
}

void TestCommandLine::aWindowWithoutAHomeMakesNoFolders() {
    const QTemporaryDir place;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
        environment.remove(name);
    environment.insert("HOME", place.filePath("missing"));
    environment.insert("TMPDIR", place.path());
    QProcess window;
    window.setProcessEnvironment(environment);
    window.start(QStringLiteral(DRILLWAVE_PROGRAM), {"-platform", "offscreen"});
    // The window keeps its files below a folder of its own.
    QTRY_VERIFY_WITH_TIMEOUT(!QDir(place.path()).entryList({"drillwave-*"}, QDir::Dirs).isEmpty(), 30000);
    const QString home = place.filePath(QDir(place.path()).entryList({"drillwave-*"}, QDir::Dirs).first());
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(home + "/.local/share/drillwave"), 30000);
    QVERIFY(!QFileInfo::exists(place.filePath("missing")));
    window.kill();
    QVERIFY(window.waitForFinished());
    const QByteArray error = window.readAllStandardError();
    QVERIFY2(!error.contains("does not support"), error);
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"
