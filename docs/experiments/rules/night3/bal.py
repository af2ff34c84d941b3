import numpy as np, sys
F={"own":394.9,"terrace":838.8,"statue":460.8,"flowers":539.0,"showroom":1024,"campsite":1091}
def rx(r): p,b=divmod(r,64); return p%2*8+b%8
def ry(r): p,b=divmod(r,64); return p//2*8+b//8
own=np.array([(rx(r)+2*ry(r))%4 for r in range(256)])
grp=np.array([next(g for g in range(4) if (q%4)==(g+2*(q//4))%4) for q in range(16)])
lane=np.zeros((256,16),int)
for r in range(256):
    for q in range(16): lane[r,q]=own[r]*4+grp[q]
for n in sys.argv[1:]:
    d=np.fromfile(n+'.load',dtype=np.uint32).reshape(-1,256,16).astype(np.int64)
    tot=d.sum(); w=d.reshape(len(d),-1); L=np.zeros((len(d),16),np.int64)
    for k in range(16): L[:,k]=w[:,(lane==k).ravel()].sum(1)
    ru=L.reshape(-1,4,4)
    fl=[v for k,v in F.items() if n.startswith(k)][0]
    # regions: most quads of one region: a region is serial only by hazard (one quad each 4 cycles)
    hot=d.max((1,2))
    f=lambda x: '%.0f k (%.2f)'%(x/1e3,x/1e3/fl)
    print(n,'windows',len(d),'empty',int((w.sum(1)==0).sum()),'quads/16',f(tot/16),'max over RUs by window',f((ru.sum(2)/4).max(1).sum()),'max over 16 groups by window',f(L.max(1).sum()),'max over groups, whole frame',f(L.sum(0).max()),'quad serial 4 cycles by window',f(np.maximum(L.max(1),4*hot).sum()))
    # two windows at once in RUs: pairs of neighbours
    busy=L[w.sum(1)>0]
    for k in (2,3,4):
        m=len(busy)//k*k
        print('   sum over %d windows in turn, max group: %s'%(k,f(busy[:m].reshape(-1,k,16).sum(1).max(1).sum()+busy[m:].sum(0).max())))
