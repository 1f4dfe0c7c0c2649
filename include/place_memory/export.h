#ifndef PLACE_MEMORY_EXPORT_H
#define PLACE_MEMORY_EXPORT_H

/// What other packages may link: the shared libraries hide all that does not carry it.
#define PLACE_MEMORY_PUBLIC __attribute__((visibility("default")))

#endif  // PLACE_MEMORY_EXPORT_H
