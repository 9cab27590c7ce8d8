// Four moments of depth, blurred before they are read (Peters & Klein 2015; Peters et al. 2017).

import package::moments::msm::umbrage_moments_visibility;
import package::sampling::blurred::umbrage_filter;
