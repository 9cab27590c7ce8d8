// A bell of bilinear lookups, each texel compared with a depth of its own, and read with three others.

import package::sampling::kernel_bell::umbrage_kernel;
import package::sampling::quads::umbrage_filter;
