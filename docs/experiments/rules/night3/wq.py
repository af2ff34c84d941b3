import numpy as np, sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import *
S={n:Scene(n) for n in sys.argv[1:]}
def quant(w,mode):
    f=w/256
    if mode=='exact': return f
    if mode=='4': return np.ceil(f*4)/4
    if mode=='r4': return np.maximum(np.round(f*4),0.25)/4*1.0 if False else np.maximum(np.round(f*4)/4,1/8)
    if mode=='pow': return 2.0**np.ceil(np.log2(np.maximum(f,1/256)))
    if mode=='half': return np.where(f>=0.5,1.0,0.0)
    if mode=='one': return np.ones_like(f)
for mode in ('exact','4','r4','pow','half','one'):
    for step in (0,1,2,3,4):
        rows=[]
        for n,s in S.items():
            g=s.grp; nb=(s.nb>>step)+1
            d=np.zeros((len(s.walks),nb+1)); v=g[:,3]*quant(g[:,4],mode)
            np.add.at(d,(g[:,0],g[:,1]>>step),v); np.add.at(d,(g[:,0],np.maximum(g[:,1],g[:,2])//(1<<step)+1),-v)
            p=d.cumsum(1).max(1)
            for i,w in enumerate(s.walks):
                if w[1]=='W': rows.append((s.peak['r'][i],p[i]))
        r=np.array(rows); th=r[r[:,0]>5632,1].min(); th2=np.sort(r[r[:,0]>5632,1])[2]
        print(mode,step,'cap all',int(th),'split',int((r[:,1]>=th).sum()),'| cap but two',int(th2),int((r[:,1]>=th2).sum()),'of',int((r[:,0]>5632).sum()),'corr %.3f'%np.corrcoef(np.log(r[r[:,0]>500]).T)[0,1])
