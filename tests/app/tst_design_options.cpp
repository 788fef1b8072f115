// SPDX-License-Identifier: GPL-3.0-or-later
// The words of `drillwave design`: what they ask, and the exit code of what is wrong with them.
#include <QTest>

#include "app/command.h"
#include "app/design_options.h"

using namespace drillwave;

namespace {

DesignStudy read(std::vector<std::string> words, DesignFaults& faults, const DesignSetup& setup = {}) {
    words.insert(words.begin(), "FILE");
    Scenario base;
    base.drill.blowFrequency = 60;
    return designStudyOf(parseArguments(designCommand(), words), base, setup, faults);
}

/// The exit code, and how many lines.
std::pair<ExitCode, std::size_t> refused(const std::vector<std::string>& words) {
    DesignFaults faults;
    read(words, faults);
    try {
        faults.check();
    } catch (const CommandError& error) {
        return {error.code(), error.lines().size()};
    }
    return {ExitCode::done, 0};
}

const std::string gap = "bit_rock.gap=0mm:1mm";

}  // namespace

class TestDesignOptions : public QObject {
    Q_OBJECT

  private slots:
    void aimsAreTakenWhereNoneAreGiven();
    void severalAimsMayStandBehindOneOption();
    void samplesArePowersOfTwo();
    void faultsHaveTheirExitCodes();
    void theFileStandsForWhatIsNotGiven();
    void faultsOfTheFileAreNamedByItsKeys();
};

void TestDesignOptions::aimsAreTakenWhereNoneAreGiven() {
    DesignFaults faults;
    const DesignStudy study = read({"--uncertain", gap}, faults);
    QCOMPARE(study.aims.size(), std::size_t{2});
    QCOMPARE(study.aims[0].name(), std::string("max:efficiency@q05"));
    QCOMPARE(study.aims[1].name(), std::string("min:thrust@q95"));
    faults.check();
}

void TestDesignOptions::severalAimsMayStandBehindOneOption() {
    DesignFaults faults;
    const DesignStudy study = read({"--uncertain", gap, "--aim", "max:cor@mean", "min:thrust@max"}, faults);
    QCOMPARE(study.aims.size(), std::size_t{2});
    QCOMPARE(study.aims[1].name(), std::string("min:thrust@max"));
}

void TestDesignOptions::samplesArePowersOfTwo() {
    DesignFaults faults;
    QCOMPARE(read({"--uncertain", gap, "--samples", "1000"}, faults).samples, std::uint64_t{1024});
    QCOMPARE(read({"--uncertain", gap, "--samples", "1"}, faults).samples, std::uint64_t{64});
}

void TestDesignOptions::faultsHaveTheirExitCodes() {
    using Refusal = std::pair<ExitCode, std::size_t>;
    QCOMPARE(refused({}), Refusal(ExitCode::usage, 1));
    QCOMPARE(refused({"--uncertain", gap, "--aim", "max:efficiency@q0"}), Refusal(ExitCode::usage, 1));
    QCOMPARE(refused({"--uncertain", gap, "--choose", "rod.length=3m:4m:10001"}),
             Refusal(ExitCode::usage, 1));
    QCOMPARE(refused({"--uncertain", gap, gap}), Refusal(ExitCode::invalidScenario, 1));
    QCOMPARE(refused({"--uncertain", "beta=1:2", "bit_rock.stiffness=50MN/m:90MN/m"}),
             Refusal(ExitCode::invalidScenario, 1));
    QCOMPARE(refused({"--uncertain", gap, "--at-most", "thrust@q95=5mm"}),
             Refusal(ExitCode::invalidScenario, 1));
    QCOMPARE(refused({"--uncertain", "bit_rock.gamma=0.3:0.1", "bit_rock.gap=0mm:0mm", "--at-most",
                      "thrust@q95=5mm"}),
             Refusal(ExitCode::invalidScenario, 3));
    // a word that cannot be read names its key all the same
    QCOMPARE(refused({"--uncertain", "bit_rock.gap=1mm:0mm", gap}), Refusal(ExitCode::invalidScenario, 2));
    QCOMPARE(refused({"--uncertain", gap, "--choose", "bit_rock.gap=nothing"}),
             Refusal(ExitCode::invalidScenario, 2));
    QCOMPARE(refused({"--uncertain", gap}), Refusal(ExitCode::done, 0));
    QCOMPARE(refused({"--uncertain", gap, "--choose", "hammer=heavy,light"}), Refusal(ExitCode::done, 0));
    QCOMPARE(refused({"--uncertain", gap, "--choose", "hammer=all"}), Refusal(ExitCode::done, 0));
    QCOMPARE(refused({"--uncertain", gap, "--choose", "hammer=heawy"}), Refusal(ExitCode::usage, 1));
    QCOMPARE(refused({"--uncertain", gap, "--choose", "bit=T38, 76 mm"}),
             Refusal(ExitCode::invalidScenario, 1));
}

void TestDesignOptions::theFileStandsForWhatIsNotGiven() {
    DesignSetup setup{.uncertain = {gap},
                      .choose = {"hammer=heavy,light"},
                      .aims = {"max:cor@mean"},
                      .atMost = {"thrust@q95=8kN"},
                      .atLeast = {},
                      .keepEnergy = false,
                      .samples = 100,
                      .seed = 7};
    DesignFaults faults;
    const DesignStudy ofFile = read({}, faults, setup);
    faults.check();
    QCOMPARE(ofFile.uncertain.size(), std::size_t{1});
    QCOMPARE(ofFile.choices.front().key(), std::string_view("hammer"));
    QCOMPARE(ofFile.aims.front().name(), std::string("max:cor@mean"));
    QCOMPARE(ofFile.limits.front().bound, 8000.0);
    QCOMPARE(ofFile.samples, std::uint64_t{128});
    QCOMPARE(ofFile.seed, std::uint64_t{7});
    const DesignStudy replaced = read({"--choose", "rod.length=3m,4m", "--samples", "64", "--at-least",
                                       "efficiency@mean=0.1", "--keep-energy"},
                                      faults, setup);
    faults.check();
    QCOMPARE(replaced.choices.front().key(), std::string_view("rod.length"));
    QCOMPARE(replaced.samples, std::uint64_t{64});
    QCOMPARE(replaced.seed, std::uint64_t{7});
    QCOMPARE(replaced.limits.size(), std::size_t{2});
    QVERIFY(replaced.keepsEnergy && replaced.uncertain == ofFile.uncertain);
    setup.keepEnergy = true;
    QVERIFY(read({"--choose", "rod.length=3m,4m"}, faults, setup).keepsEnergy);
    QVERIFY(!read({"--choose", "rod.length=3m,4m", "--no-keep-energy"}, faults, setup).keepsEnergy);
    faults.check();
}

void TestDesignOptions::faultsOfTheFileAreNamedByItsKeys() {
    const DesignSetup setup{.uncertain = {"bit_rock.gap=1mm:0mm"},
                            .choose = {},
                            .aims = {"max:cor"},
                            .atMost = {"thrust@q95=8mm"},
                            .atLeast = {},
                            .keepEnergy = false,
                            .samples = {},
                            .seed = {}};
    DesignFaults faults;
    read({}, faults, setup);
    try {
        faults.check();
        QFAIL("is taken");
    } catch (const CommandError& error) {
        QCOMPARE(error.lines().size(), std::size_t{3});
        QVERIFY(error.lines()[0].starts_with("design.uncertain: "));
        QVERIFY(error.lines()[1].starts_with("design.aims max:cor: "));
        QVERIFY(error.lines()[2].starts_with("design.at_most thrust@q95=8mm: "));
    }
}

QTEST_GUILESS_MAIN(TestDesignOptions)
#include "tst_design_options.moc"
