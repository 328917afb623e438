#pragma once

namespace ar3d {

/// Adds the drawing format that needs more than formats/ may include: the viewer's page, which
/// judges what it shows. To be called once, before the verbs are.
void register_program_formats();

}  // namespace ar3d
