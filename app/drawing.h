// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that commands write.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/blow.h"
#include "core/file/whole_folder.h"
#include "core/study/paper/figure_data.h"

namespace drillwave {

/// Draws; what it draws with is another program's matter (desktop.h).
class Drawing {
  public:
    Drawing() = default;
    virtual ~Drawing() = default;
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// A figure of the paper in one of the pictureFormats; empty where it could not be drawn.
    virtual std::string figure(const Figure& figure, std::string_view format) const = 0;

    /// blow.* and rock.* of a blow solved with Detail::histories, in each format. Throws CommandError
    /// (unwritable output) where they could not be drawn. Not all of them after a stop.
    virtual std::vector<NamedFile> blow(const Blow& blow, const std::vector<std::string>& formats,
                                        const std::stop_token& stop) const = 0;
};

}  // namespace drillwave
