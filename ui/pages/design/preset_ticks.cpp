// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/preset_ticks.h"

#include <QCheckBox>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>
#include <algorithm>

#include "ui/pages/study/flow_layout.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString partName(PresetPart part) {
    switch (part) {
        case PresetPart::hammer:
            return PresetTicks::tr("hammers");
        case PresetPart::rod:
            return PresetTicks::tr("rods");
        case PresetPart::bit:
            return PresetTicks::tr("bits");
        case PresetPart::rock:
            break;  // no design variable
    }
    return {};
}

bool isThere(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

PresetTicks::PresetTicks(QWidget* parent) : QWidget(parent) {
    const PresetLibrary library;
    for (const PresetSource& source : library.sources()) {
        m_presets.presets.insert(m_presets.presets.end(), source.presets.begin(), source.presets.end());
        m_presets.sectionPresets.insert(m_presets.sectionPresets.end(), source.sectionPresets.begin(),
                                        source.sectionPresets.end());
    }
    auto* layout = new FlowLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (const PresetPart part : {PresetPart::hammer, PresetPart::rod, PresetPart::bit}) {
        auto* button = new QToolButton(this);
        button->setObjectName(QString::fromUtf8(name(part).data(), qsizetype(name(part).size())));
        button->setPopupMode(QToolButton::InstantPopup);
        button->setToolTip(tr("Ticked presets are compared as designs"));
        button->setMenu(new QMenu(button));
        layout->addWidget(button);
        m_parts.push_back({part, button, {}, {}});
    }
}

void PresetTicks::present(const Scenario& scenario) {
    m_scenario = scenario;
    for (Part& part : m_parts) offer(part);
}

// A menu that is open keeps its boxes: they are replaced only where other presets fit.
void PresetTicks::offer(Part& part) {
    std::vector<PartPreset> fitting;
    std::vector<std::string> names;
    if (partProblem(part.part, m_scenario).isEmpty()) {
        const auto add = [&](const PartPreset& preset) {
            if (!suits(preset, part.part, m_scenario) || isThere(names, nameOf(preset))) return;
            names.push_back(nameOf(preset));
            fitting.push_back(preset);
        };
        for (const Preset& preset : m_presets.presets) add(preset);
        for (const SectionPreset& preset : m_presets.sectionPresets) add(preset);
    }
    part.button->setVisible(!fitting.empty());
    if (fitting == part.offered) return;
    part.offered = std::move(fitting);
    std::erase_if(part.ticked, [&](const std::string& name) { return !isThere(names, name); });
    QMenu* menu = part.button->menu();
    menu->clear();
    for (const std::string& name : names) {
        auto* box = new QCheckBox(coreText(name), menu);
        box->setObjectName(QString::fromStdString(name));
        box->setChecked(isThere(part.ticked, name));
        auto* action = new QWidgetAction(menu);  // a menu stays open while its boxes are ticked
        action->setDefaultWidget(box);
        menu->addAction(action);
        connect(box, &QCheckBox::toggled, this, [this, &part, name](bool isTicked) {
            set(part, name, isTicked);
            emit changed();
        });
    }
    showNames(part);
}

// Keeps the order of the menu.
void PresetTicks::set(Part& part, const std::string& name, bool isTicked) {
    std::vector<std::string> ticked;
    for (const PartPreset& preset : part.offered) {
        const std::string& each = nameOf(preset);
        if (each == name ? isTicked : isThere(part.ticked, each)) ticked.push_back(each);
    }
    part.ticked = std::move(ticked);
    showNames(part);
}

void PresetTicks::showNames(Part& part) {
    const QString title = partName(part.part);
    part.button->setText(part.ticked.empty() ? title
                                             : QStringLiteral("%1 (%2)").arg(title).arg(part.ticked.size()));
    part.button->setAccessibleName(tr("%1 to choose from").arg(title));
}

std::vector<std::string> PresetTicks::texts() const {
    std::vector<std::string> texts;
    for (const Part& part : m_parts) {
        if (part.ticked.empty()) continue;
        std::string text = std::string(name(part.part)) + "=";
        for (const std::string& each : part.ticked) text += (each == part.ticked.front() ? "" : ",") + each;
        texts.push_back(std::move(text));
    }
    return texts;
}

bool PresetTicks::tick(const std::string& text) {
    const ParsedAxis parsed = parseChoice(text, m_scenario, lookup());
    if (!parsed.problem.isEmpty() || !parsed.axis.presets) return false;
    for (Part& part : m_parts) {
        if (part.part != parsed.axis.presets->part()) continue;
        for (const std::string_view each : parsed.axis.presets->words()) {
            const std::string name(each);
            set(part, name, true);
            for (auto* box : part.button->menu()->findChildren<QCheckBox*>()) {
                const QSignalBlocker quiet(box);
                if (box->objectName().toStdString() == name) box->setChecked(true);
            }
        }
    }
    return true;
}

void PresetTicks::clear() {
    for (Part& part : m_parts) {
        part.ticked.clear();
        for (auto* box : part.button->menu()->findChildren<QCheckBox*>()) {
            const QSignalBlocker quiet(box);
            box->setChecked(false);
        }
        showNames(part);
    }
}

std::vector<std::string> PresetTicks::keys() const {
    std::vector<std::string> keys;
    for (const std::string& text : texts())
        if (const ParsedAxis parsed = parseChoice(text, m_scenario, lookup()); parsed.axis.presets)
            for (const std::string_view key : parsed.axis.presets->keys()) keys.emplace_back(key);
    return keys;
}

bool PresetTicks::hasHammers() const {
    return !m_parts.front().ticked.empty();
}

PresetLookup PresetTicks::lookup() const {
    return {.presets = [this]() -> const PresetFile& { return m_presets; }};
}

}  // namespace drillwave
