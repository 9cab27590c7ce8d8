// The mean of bilinear lookups, one texel apart, each texel compared with a depth of its own, and read with three others.

import package::sampling::kernel_box::umbrage_kernel;
import package::sampling::quads::umbrage_filter;
