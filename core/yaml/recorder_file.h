// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of recorders by name, in recorders.yaml: the options by which their records are read, as words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/signal/signal_reading.h"
#include "core/text/message.h"

namespace drillwave {

/// The first key of such a file, and the newest format number that this program reads.
inline constexpr std::string_view recorderKey = "drillwave_recorders";
inline constexpr int recorderFormat = 1;

/// A file that is larger is none.
inline constexpr std::size_t maximumRecorderBytes = std::size_t{1} << 20;

struct Recorder {
    std::string name;
    std::vector<std::pair<std::string, std::string>> settings;  ///< names of signalOptions() and their values
    bool operator==(const Recorder&) const = default;
};

/// The recorders of a file in its order, or what is wrong with it: "recorders.yaml:4:5: …".
struct RecorderFile {
    std::vector<Recorder> recorders;
    std::vector<Message> problems;
    bool isUnreadable = false;  ///< the problem is one of the disk
};

/// `source` names the text in messages.
RecorderFile parseRecorders(std::string_view text, const std::string& source);

/// The recorder of that name, or nullptr.
const Recorder* findRecorder(const std::vector<Recorder>& recorders, std::string_view name);

/// The recorders with one more, or with that one changed; the others keep their order.
std::vector<Recorder> withRecorder(std::vector<Recorder> recorders, Recorder recorder);

/// The text of such a file; parseRecorders() reads the same recorders from it.
std::string recorderText(const std::vector<Recorder>& recorders);

/// recorders.yaml beside the user's presets.yaml.
std::string recordersPath();

/// Reads such a file; where there is none it has no recorders.
RecorderFile loadRecorders(const std::string& path);

/// Writes such a file, with its folder. Returns why it could not; empty when it was written.
Message saveRecorders(const std::string& path, const std::vector<Recorder>& recorders);

/// Sets the options that the settings name, and no others. Returns a problem of one of them.
Message applyRecorder(const Recorder& recorder, SignalOptions& options);

}  // namespace drillwave
