"""The binary protocol of iFacialMocap and Facemotion3D."""
