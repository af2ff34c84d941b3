// SPDX-License-Identifier: Apache-2.0
// template.hpp: the HTML files that are filled with data: made by sim/report/page/build.sh when they are first needed.
//
// Idea    Style, scripts and the libraries inside come from npm and are bundled once into the build folder, so a build
//         of the program needs neither, and a page needs no network.
// Errors  OwnFailure: npm or a library is not to be had; names the log.
#pragma once

#include <string>

namespace pipegs {

// The contents of the template `name`, as "page".
std::string html_template(const std::string& name);

}  // namespace pipegs
