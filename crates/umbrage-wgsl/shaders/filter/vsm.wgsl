// Mean and variance of depth, blurred before they are read (Donnelly & Lauritzen 2006).

import package::moments::vsm::umbrage_moments_visibility;
import package::sampling::blurred::umbrage_filter;
