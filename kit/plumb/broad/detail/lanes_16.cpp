// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/broad/detail/block_search_wide.h>
#include <plumb/broad/detail/box_probe_wide.h>

template struct plumb::WideBlockSearch<16>;
template struct plumb::WideBoxProbe<16>;
#endif
